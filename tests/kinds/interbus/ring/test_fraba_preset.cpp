// SPDX-License-Identifier: GPL-3.0-or-later
// On a ring, 60000000 must not be seen twice: the encoder would set its position, and write its EEPROM, in
// each cycle (FRABA manual 5.4.1).
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_session.h"
#include "tests/support/places.h"
#include "tests/support/scripted_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;

constexpr Place place = "1.0"_ring;
constexpr Word frabaPreset = 0x6000'0000;
constexpr SetPreset presetJob{{}, PresetCommand::manufacturer};

class FrabaPresetOnTheRing : public testing::Test
{
protected:
    FrabaPresetOnTheRing()
    {
        auto link = std::make_unique<ScriptedLink>(
            RingStructure{{place.node, 0x0237, 2, 2, QStringLiteral("fraba-ocd-ib")}});
        m_link = link.get();
        m_link->answerWith([this](std::size_t, Word out) {
            m_seen += out == frabaPreset ? 1 : 0;
            return m_seen > 0 ? Word{100} : Word{12'345};
        });
        m_bus = std::make_unique<RingSession>(std::move(link), m_catalog, QDateTime());
    }
    void open(RingSession::Start start = RingSession::Start::operating)
    {
        ASSERT_TRUE(m_bus->open(start));
        encoder().tell(Parameter::startUpMode, 1);
        QObject::connect(&encoder(), &EncoderSession::finished, m_bus.get(),
                         [this](const Outcome &outcome) { m_outcome = outcome; });
        QObject::connect(m_bus->channel(place), &WordChannel::refused, m_bus.get(),
                         [this](const Refusal &why) { m_refused.push_back(why.id); });
        m_bus->advance(3);
        encoder().tell(Parameter::preset, 100);
        m_bus->advance(1);
    }
    EncoderSession &encoder() { return *m_bus->encoder(place); }
    void write(Word word)
    {
        m_bus->channel(place)->stage(word);
        ASSERT_TRUE(m_bus->channel(place)->write());
    }

    const Catalog m_catalog = Catalog::builtIn();
    ScriptedLink *m_link = nullptr;
    std::unique_ptr<RingSession> m_bus;
    int m_seen = 0; // cycles in which 60000000 was exchanged
    std::optional<Outcome> m_outcome;
    std::vector<RefusalCode> m_refused;
};

TEST_F(FrabaPresetOnTheRing, AJobSendsItForOneCycle)
{
    open();
    ASSERT_TRUE(encoder().start(presetJob, Pace::byItself));
    m_bus->advance(100);
    EXPECT_EQ(m_seen, 1);
    ASSERT_TRUE(m_outcome);
    EXPECT_TRUE(m_outcome->result);
    EXPECT_EQ(m_outcome->positionAfter, 100);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(Word{0}));
}

TEST_F(FrabaPresetOnTheRing, AWordOfAMonitorIsTakenAwayAfterOneCycle)
{
    open();
    write(frabaPreset);
    m_bus->advance(100);
    EXPECT_EQ(m_seen, 1);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(Word{0}));
    EXPECT_EQ(encoder().eepromWrites(), 1);
}

TEST_F(FrabaPresetOnTheRing, ABusStoppedBehindItDoesNotSendItAgain)
{
    open();
    ASSERT_TRUE(encoder().start(presetJob, Pace::byItself));
    for (int cycle = 0; m_seen == 0; ++cycle) {
        ASSERT_LT(cycle, 100);
        m_bus->advance(1);
    }
    m_bus->setRunning(false);
    m_bus->advance(5);
    m_bus->setRunning(true);
    m_bus->advance(100);
    EXPECT_EQ(m_seen, 1);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(Word{0}));
}

TEST_F(FrabaPresetOnTheRing, ALinkThatFailedBehindItDoesNotSendItAgain)
{
    open();
    write(frabaPreset);
    m_link->failAt(2);
    m_bus->advance(5);
    EXPECT_FALSE(m_bus->isRunning());
    m_bus->setRunning(true);
    m_bus->advance(100);
    EXPECT_EQ(m_seen, 1);
}

TEST_F(FrabaPresetOnTheRing, WatchInTheSameCycleKeepsItFromGoingOut)
{
    open();
    write(frabaPreset);
    m_bus->setOperate(false);
    m_bus->advance(100);
    EXPECT_EQ(m_seen, 0);
}

TEST_F(FrabaPresetOnTheRing, InWatchAWordOfSomebodyElseIsLeftAlone)
{
    m_link->setPeerOut({frabaPreset});
    open(RingSession::Start::watching);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(frabaPreset));
}

// A gateway that runs the ring on its own
TEST_F(FrabaPresetOnTheRing, IsNotOfferedByALinkThatRepeatsWords)
{
    m_link->repeatWordsByItself();
    open();
    EXPECT_FALSE(encoder().can().manufacturerPreset);
    EXPECT_TRUE(encoder().can().presets);
    const Refusal refusal{RefusalKind::notSupported, RefusalId::linkDoesNotBoundCycles, {frabaPreset}};
    EXPECT_EQ(encoder().start(presetJob, Pace::byItself).error(), refusal);
    EXPECT_EQ(encoder().start(SendWords{.words = {0, frabaPreset}}, Pace::byItself).error(), refusal);
    write(frabaPreset);
    m_bus->advance(100);
    EXPECT_THAT(m_refused, ElementsAre(RefusalId::linkDoesNotBoundCycles));
    EXPECT_EQ(m_seen, 0);
}

} // namespace
} // namespace codewheel
