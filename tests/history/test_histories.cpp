// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "history/histories.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/support/places.h"

#include <QCoreApplication>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::Not;

const Catalog &catalog()
{
    static const Catalog builtIn = Catalog::builtIn();
    return builtIn;
}

const QDateTime began(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC);

// The training ring and a line beside it.
class HistoriesTest : public testing::Test
{
protected:
    HistoriesTest()
    {
        buses.add(ring);
        buses.add(line);
        EXPECT_TRUE(ring.open(EncoderBus::Start::operating));
        EXPECT_TRUE(line.open({}, {}, EncoderBus::Start::operating, EncoderBus::Drive::byHand));
        EXPECT_TRUE(line.add({5}, QStringLiteral("kuebler-esc-rs485")));
        for (const auto &[parameter, value] :
             {std::pair(Parameter::startUpMode, 1), {Parameter::steps, 8'192}, {Parameter::revolutions, 1}})
            ring.encoder(standing)->tell(parameter, value);
        training.controls->setSpeed(turning.node, 60);
    }
    void advance(Instant duration)
    {
        for (Instant passed{}; passed < duration; passed += 33ms) {
            ring.advance(33ms);
            line.advance(33ms);
        }
    }
    const MemoryHistory &position(Place place) const { return histories.of(place)->of(Channel::position); }

    const Place standing = "1.0"_ring;
    const Place turning = "4.0"_ring;
    const Place onLine = placeOnLine({5});
    TrainingBus training = makeTrainingBus(catalog());
    RingSession ring{std::move(training.link), catalog(), began};
    EscLineSession line{std::make_unique<SimulatedEscLineLink>(std::make_shared<SimulatedEscLine>()),
                        catalog(), began, [](const DeviceDescription &device, EscLineAddress address) {
                            return std::make_unique<EscDriver>(device, address);
                        }};
    Buses buses;
    Histories histories{buses};
};

TEST_F(HistoriesTest, EveryCycleOfEveryEncoderIsKeptWhateverItsBus)
{
    advance(1s);
    EXPECT_THAT(histories.places(), Contains(standing));
    EXPECT_THAT(histories.places(), Contains(onLine));
    EXPECT_NEAR(static_cast<double>(position(turning).size()), 1'000, 30);
    EXPECT_GT(position(onLine).span()->to - position(onLine).span()->from, 800ms);
    EXPECT_GT(position(turning).extent({Instant::min() / 2, Instant::max() / 2})->greatest,
              position(turning).extent({Instant::min() / 2, Instant::max() / 2})->least);
    EXPECT_EQ(histories.of("9.0"_ring), nullptr);
}

TEST_F(HistoriesTest, TimesAreThoseOfTheDay)
{
    advance(1s);
    const Instant begin = std::chrono::milliseconds(began.toMSecsSinceEpoch());
    for (const Place place : {turning, onLine}) {
        EXPECT_GE(position(place).span()->from, begin);
        EXPECT_LE(position(place).span()->to, begin + 1100ms);
        EXPECT_GT(position(place).span()->to, begin + 900ms);
    }
}

TEST_F(HistoriesTest, ATurningShaftHasASpeed)
{
    advance(3s);
    const MemoryHistory &speed = histories.of(turning)->of(Channel::speed);
    const auto last = speed.newest();
    ASSERT_TRUE(last);
    EXPECT_NEAR(static_cast<double>(last->value) / 1e3,
                ring.encoder(turning)->latest().stepsPerSecond.value(), 1.0);
    EXPECT_LE(speed.size(), 310U);
}

TEST_F(HistoriesTest, WhileTheBusIsStoppedThereIsAGap)
{
    advance(500ms);
    const std::size_t before = position(turning).size();
    ring.setRunning(false);
    advance(500ms);
    EXPECT_LE(position(turning).size(), before + 1);
    ASSERT_EQ(position(turning).gaps().size(), 1U);
    EXPECT_EQ(position(turning).gaps().back().to, Instant::max());
    ring.setRunning(true);
    advance(500ms);
    EXPECT_NEAR(static_cast<double>(
                    (position(turning).gaps().back().to - position(turning).gaps().back().from) / 1ms),
                500, 40);
}

TEST_F(HistoriesTest, AnOrderedJumpIsMarkedAndIsNoSpeed)
{
    advance(2s);
    ASSERT_TRUE(ring.encoder(standing)->start(SetPreset{.value = 100}));
    advance(3s);
    const EncoderHistory &history = *histories.of(standing);
    const auto preset = std::ranges::find_if(histories.marks(), [&](const Mark &mark) {
        const auto *message = std::get_if<Message>(&mark.what);
        return message != nullptr && message->id == MessageId::presetDone && mark.place == standing;
    });
    ASSERT_NE(preset, histories.marks().end());
    EXPECT_GT(preset->at, history.span()->from);
    EXPECT_LT(preset->at, history.span()->to);
    EXPECT_EQ(history.of(Channel::position).newest()->value, 100);
    const auto speeds = history.of(Channel::speed).extent({Instant::min() / 2, Instant::max() / 2});
    ASSERT_TRUE(speeds);
    EXPECT_EQ(*speeds, (Extent{0, 0}));
}

TEST_F(HistoriesTest, WhatAStepWasIsKeptWithTheTimeOfItsChange)
{
    advance(1s);
    ASSERT_EQ(histories.scales(standing).size(), 1U);
    EXPECT_EQ(histories.scales(standing)[0].scale.stepsPerTurn, 8'192);
    const Instant before = histories.span()->to;
    ASSERT_TRUE(ring.encoder(standing)->start(
        WriteParameters{.values = {{Parameter::steps, 4'096}}, .previous = {}}));
    advance(5s);
    const std::vector<ScaleSince> scales = histories.scales(standing);
    ASSERT_EQ(scales.size(), 2U);
    EXPECT_EQ(scales[0].scale.stepsPerTurn, 8'192);
    EXPECT_EQ(scales[1].scale.stepsPerTurn, 4'096);
    EXPECT_GT(scales[1].from, before);
    const auto gaps = position(standing).gaps({before, histories.span()->to});
    ASSERT_FALSE(gaps.empty());
    EXPECT_LE(scales[1].from, gaps.back().to) << "what it shows after the change is scaled anew";
    EXPECT_GE(scales[1].from, gaps.front().from) << "what it showed before is not";
}

TEST_F(HistoriesTest, WhatWasToldAndIsToldOtherwiseWasNeverSo)
{
    advance(1s);
    ring.encoder(standing)->tell(Parameter::steps, 4'096);
    advance(1s);
    ASSERT_EQ(histories.scales(standing).size(), 1U);
    EXPECT_EQ(histories.scales(standing)[0].scale.stepsPerTurn, 4'096);
}

TEST_F(HistoriesTest, WordsAreKeptOfAnEncoderThatHasThem)
{
    advance(1s);
    const EncoderHistory &onRing = *histories.of(turning);
    EXPECT_EQ(onRing.of(Channel::in).newest()->value, ring.channel(turning)->in());
    EXPECT_EQ(onRing.of(Channel::out).newest()->value, 0);
    EXPECT_LE(onRing.of(Channel::out).size(), 2U);
    EXPECT_TRUE(histories.of(onLine)->of(Channel::in).isEmpty());
}

TEST_F(HistoriesTest, TheUserNotesWhatHappened)
{
    advance(1s);
    int told = 0;
    QObject::connect(&histories, &Histories::marksChanged, &histories, [&] { ++told; });
    const std::size_t before = histories.marks().size();
    const Instant at = histories.span()->from + 500ms;
    histories.note(at, QStringLiteral("Coupling tightened"));
    histories.note(at, QStringLiteral("Coupling tightened, 20 Nm"));
    ASSERT_EQ(histories.marks().size(), before + 1);
    EXPECT_TRUE(std::ranges::is_sorted(histories.marks(), {}, &Mark::at));
    histories.note(at, {});
    EXPECT_EQ(histories.marks().size(), before);
    QCoreApplication::processEvents();
    EXPECT_EQ(told, 1) << "once for all that came in one go";
}

TEST_F(HistoriesTest, WhatWasDroppedIsCounted)
{
    Q_EMIT ring.valuesDropped(17);
    EXPECT_EQ(histories.dropped(), 17U);
}

TEST_F(HistoriesTest, WhatIsOldestMakesRoomForAll)
{
    histories.setLimit(700'000);
    advance(40s);
    EXPECT_LE(histories.bytes(), 700'000U);
    const Instant begin = std::chrono::milliseconds(began.toMSecsSinceEpoch());
    EXPECT_GT(position(turning).span()->from, begin + 1s);
    EXPECT_LT(position(standing).span()->from, begin + 1s) << "what stands costs next to nothing";
}

TEST_F(HistoriesTest, TellsHowFarBackItWillReach)
{
    EXPECT_FALSE(histories.reach());
    advance(10s);
    const double perSecond = 8.5 * 1'000 * 4; // of the ring; three others show none as yet
    const double seconds = static_cast<double>(histories.limit()) / perSecond;
    EXPECT_NEAR(std::chrono::duration<double>(*histories.reach()).count(), seconds, seconds / 3);
}

TEST_F(HistoriesTest, AnEncoderTakesItsHistoryToItsNewAddress)
{
    advance(1s);
    const Place there = placeOnLine({0x07});
    std::vector<std::pair<Place, Place>> moves;
    QObject::connect(&histories, &Histories::moved, &histories,
                     [&](Place from, Place to) { moves.emplace_back(from, to); });
    ASSERT_TRUE(line.encoder(onLine)->start(
        WriteParameters{.values = {{Parameter::lineAddress, 7}}, .previous = {}}));
    advance(3s);
    EXPECT_THAT(moves, testing::ElementsAre(std::pair(onLine, there)));
    ASSERT_NE(histories.of(there), nullptr);
    EXPECT_EQ(histories.of(onLine), nullptr);
    EXPECT_LT(histories.of(there)->span()->from,
              std::chrono::milliseconds(began.toMSecsSinceEpoch()) + 500ms);
    EXPECT_GT(histories.of(there)->span()->to, std::chrono::milliseconds(began.toMSecsSinceEpoch()) + 3500ms);
}

TEST_F(HistoriesTest, AClosedBusLeavesWhatIsKept)
{
    advance(1s);
    const std::size_t before = position(turning).size();
    ring.close();
    EXPECT_GE(position(turning).size(), before);
    EXPECT_EQ(position(turning).gaps().back().to, Instant::max());
    EXPECT_TRUE(ring.open(EncoderBus::Start::watching));
    ring.setTime(began.addSecs(60));
    advance(500ms);
    EXPECT_GT(position(turning).size(), before + 400);
}

// Of another day, with one encoder that showed two positions.
class OldDay : public Archive
{
public:
    OldDay()
    {
        m_position.append({1'000s, 4});
        m_position.append({1'001s, 5});
    }
    std::vector<Place> places() const override { return {place}; }
    const History *of(Place asked, Channel channel) const override
    {
        return asked == place && channel == Channel::position ? &m_position : nullptr;
    }
    std::optional<TimeSpan> span() const override { return m_position.span(); }
    std::vector<Mark> marks() const override { return {{1'000s + shift(), {}, QStringLiteral("old")}}; }

    const Place place{BusId{77}, "1.0"_ring.node};

private:
    MemoryHistory m_position;
};

TEST_F(HistoriesTest, AnArchiveStandsBesideWhatIsWatched)
{
    advance(1s);
    int placesTold = 0;
    int archivesTold = 0;
    QObject::connect(&histories, &Histories::placesChanged, &histories, [&] { ++placesTold; });
    QObject::connect(&histories, &Histories::archivesChanged, &histories, [&] { ++archivesTold; });
    const auto before = histories.span();
    histories.note(500s, QStringLiteral("older"));
    const std::size_t marks = histories.marks().size();
    {
        OldDay old;
        histories.add(old);
        EXPECT_THAT(histories.places(), testing::Contains(old.place));
        EXPECT_EQ(histories.archiveOf(old.place), &old);
        EXPECT_EQ(histories.archiveOf(turning), nullptr);
        EXPECT_EQ(histories.of(old.place), nullptr) << "is not watched";
        EXPECT_EQ(histories.of(old.place, Channel::position)->newest()->value, 5);
        EXPECT_EQ(histories.of(old.place, Channel::speed), nullptr);
        EXPECT_EQ(histories.of(turning, Channel::position), &position(turning));
        EXPECT_EQ(histories.span(), before) << "follows what is watched";
        ASSERT_EQ(histories.marks().size(), marks + 1);
        EXPECT_EQ(histories.marks()[1].at, Instant(1'000s));
        old.setShift(-600s);
        EXPECT_EQ(histories.marks()[0].at, Instant(400s));
        histories.note(450s, QStringLiteral("between"));
        EXPECT_TRUE(std::ranges::is_sorted(histories.marks(), {}, &Mark::at));
        EXPECT_EQ(archivesTold, 2);
        EXPECT_EQ(placesTold, 1);
    }
    EXPECT_TRUE(histories.archives().empty());
    EXPECT_EQ(histories.marks().size(), marks + 1) << "the note stays";
    EXPECT_EQ(placesTold, 2);
}

} // namespace
} // namespace codewheel
