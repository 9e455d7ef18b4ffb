// SPDX-License-Identifier: GPL-3.0-or-later
// The bus does not tell the make of an encoder: the user names it.
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/ring/ring_session.h"
#include "tests/support/places.h"
#include "tests/support/scripted_link.h"

#include <QPointer>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

namespace codewheel {
namespace {

using testing::ElementsAre;

const Place encoderPlace = "1.0"_ring;
const Place inputPlace = "2.0"_ring;

// An encoder of unnamed make, and a digital input. The encoder is at 12345 and answers each parameter at
// once.
class Naming : public testing::Test
{
protected:
    Naming()
        : m_link(new ScriptedLink(
              RingStructure{{encoderPlace.node, 0x0237, 2, 2, {}}, {inputPlace.node, 0x81BE, 1, 0, {}}}))
        , m_bus(std::unique_ptr<ScriptedLink>(m_link), m_catalog,
                QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC))
    {
        m_link->answerWith([this](std::size_t, Word out) {
            ++m_sent[out];
            return out == 0 || out == 0x8000'0000 ? Word{12345} : 0xC000'0000 | out;
        });
        EXPECT_TRUE(m_bus.open(RingSession::Start::operating));
        QObject::connect(&m_bus, &RingSession::named, &m_bus,
                         [this](Place number) { m_named.push_back(number); });
        QObject::connect(&m_bus, &RingSession::messaged, &m_bus,
                         [this](const Message &message) { m_messages.push_back(message); });
        m_bus.advance(3);
    }
    EncoderSession *encoder() const { return m_bus.encoder(encoderPlace); }

    ScriptedLink *m_link; // owned by the bus
    const Catalog m_catalog = Catalog::builtIn();
    RingSession m_bus;
    std::map<Word, int> m_sent;
    std::vector<Place> m_named;
    std::vector<Message> m_messages;
};

TEST_F(Naming, GivesTheEncoderTheDriverOfItsMakeAndSendsNothing)
{
    EXPECT_TRUE(encoder()->device().isGeneric());
    EXPECT_EQ(encoder()->device().find(Parameter::direction), nullptr);
    ASSERT_TRUE(m_bus.name(encoderPlace, QStringLiteral("fraba-ocd-ib")));
    EXPECT_EQ(encoder()->device().key, QStringLiteral("fraba-ocd-ib"));
    EXPECT_TRUE(encoder()->can().reads);
    EXPECT_EQ(m_bus.structure()[0].deviceKey, QStringLiteral("fraba-ocd-ib"));
    EXPECT_THAT(m_named, ElementsAre(encoderPlace));
    encoder()->tell(Parameter::startUpMode, 1); // K3: only a FRABA driver asks for that
    m_bus.advance(5);
    EXPECT_EQ(encoder()->latest().position, 12345);
    EXPECT_EQ(m_sent.size(), 1u) << "only 00000000 went out";
    ASSERT_FALSE(m_messages.empty());
    EXPECT_EQ(m_messages.back().id, MessageId::deviceNamed);
    EXPECT_EQ(m_messages.back().place, encoderPlace);
}

TEST_F(Naming, TheDriverOfTheMakeDoesTheJobsAfterwards)
{
    ASSERT_TRUE(m_bus.name(encoderPlace, QStringLiteral("fraba-ocd-ib")));
    std::optional<Outcome> outcome;
    QObject::connect(encoder(), &EncoderSession::finished, &m_bus,
                     [&](const Outcome &finished) { outcome = finished; });
    ASSERT_TRUE(encoder()->start(ReadParameters{{Parameter::serialNumber}}));
    m_bus.advance(3000);
    ASSERT_TRUE(outcome);
    EXPECT_GT(m_sent[0x2021'0000], 0); // the generic driver has no read-out
}

TEST_F(Naming, ForgetsWhatWasKnown)
{
    const QPointer<EncoderSession> before = encoder();
    encoder()->tell(Parameter::steps, 4096);
    ASSERT_TRUE(encoder()->known(Parameter::steps));
    ASSERT_TRUE(m_bus.name(encoderPlace, QStringLiteral("baumer-gxp6w")));
    EXPECT_TRUE(before.isNull()) << "views let go of the session before";
    m_bus.advance(2);
    EXPECT_FALSE(encoder()->known(Parameter::steps));
}

TEST_F(Naming, CanBeTakenBack)
{
    ASSERT_TRUE(m_bus.name(encoderPlace, QStringLiteral("baumer-gxp6w")));
    m_bus.advance(2);
    ASSERT_TRUE(m_bus.name(encoderPlace, {}));
    m_bus.advance(2);
    EXPECT_TRUE(encoder()->device().isGeneric());
    EXPECT_EQ(m_bus.structure()[0].deviceKey, QString());
    EXPECT_EQ(encoder()->latest().state, EncoderState::operation);
}

TEST_F(Naming, TakesTheResolutionOfTheLabel)
{
    ASSERT_TRUE(m_bus.name(encoderPlace, QStringLiteral("fraba-ocd-ib"), 1, 4096));
    EXPECT_EQ(encoder()->device().physicalTurns, 1);
    EXPECT_EQ(encoder()->device().physicalStepsPerTurn, 4096);
    EXPECT_EQ(m_catalog.find(u"fraba-ocd-ib")->physicalTurns, 4096);
}

TEST_F(Naming, IsRefusedForAnotherDeviceCode)
{
    const auto named = m_bus.name(inputPlace, QStringLiteral("fraba-ocd-ib"));
    ASSERT_FALSE(named);
    EXPECT_EQ(named.error().id, RingRefusalId::deviceCodeDiffers);
    EXPECT_EQ(m_bus.encoder(inputPlace), nullptr);
    EXPECT_TRUE(m_named.empty());
}

TEST_F(Naming, IsRefusedWhileAJobRuns)
{
    ASSERT_TRUE(encoder()->start(SendWords{.words = {0x0200'00FF}, .holdCycles = 50}));
    m_bus.advance(1);
    const auto named = m_bus.name(encoderPlace, QStringLiteral("fraba-ocd-ib"));
    ASSERT_FALSE(named);
    EXPECT_EQ(named.error().id, RefusalId::jobRunning);
    EXPECT_TRUE(encoder()->device().isGeneric());
}

TEST_F(Naming, InTheMidstOfASignalOfTheSessionIsSafe)
{
    QObject::connect(encoder(), &EncoderSession::latestChanged, &m_bus, [this] {
        if (encoder()->device().isGeneric()) {
            EXPECT_TRUE(m_bus.name(encoderPlace, QStringLiteral("fraba-ocd-ib")));
        }
    });
    m_bus.advance(1);
    m_bus.advance(1);
    EXPECT_EQ(encoder()->device().key, QStringLiteral("fraba-ocd-ib"));
    EXPECT_EQ(m_named.size(), 1u);
}

// Knowledge of the previous driver must not be taken for that of the make.
TEST_F(Naming, EventsOfTheDriverBeforeAreDropped)
{
    int changes = 0;
    QObject::connect(&m_bus, &RingSession::named, &m_bus, [&] {
        QObject::connect(encoder(), &EncoderSession::knownChanged, &m_bus, [&] { ++changes; });
    });
    ASSERT_TRUE(m_bus.channel(encoderPlace));
    ASSERT_TRUE(m_bus.name(encoderPlace, QStringLiteral("fraba-ocd-ib")));
    ASSERT_TRUE(m_bus.name(encoderPlace, QStringLiteral("baumer-gxp6w")));
    m_bus.advance(10);
    EXPECT_EQ(changes, 0);
    EXPECT_EQ(encoder()->device().key, QStringLiteral("baumer-gxp6w"));
    EXPECT_EQ(encoder()->latest().state, EncoderState::operation);
}

} // namespace
} // namespace codewheel
