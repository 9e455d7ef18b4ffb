// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_outline.h"
#include "bus/buses.h"
#include "history/histories.h"
#include "recording/bus_feed.h"
#include "tests/replay/replay_recording.h"

namespace codewheel {
namespace {

using namespace test;
using Direction = Playback::Direction;

class ReplayBusTest : public testing::Test
{
protected:
    ReplayBusTest()
    {
        QObject::connect(&ring, &EncoderBus::trafficPassed, &ring,
                         [this](const TrafficRow &row) { rows.push_back(row); });
        QObject::connect(&ring, &EncoderBus::messaged, &ring,
                         [this](const Message &message) { messages.push_back(message); });
        QObject::connect(&ring, &EncoderBus::trafficRestarted, &ring, [this] { ++restarts; });
    }
    void showAt(Instant at)
    {
        playback->jumpTo(at);
        ring.pump();
        line.pump();
    }
    const EncoderSession &encoder(Place place = hoist) const { return *ring.encoder(replayed(place)); }
    const WordChannel &words(Place place = hoist) const { return *ring.channel(replayed(place)); }

    ReplayRecording recording;
    std::shared_ptr<Playback> playback = recording.playback();
    ReplayBus ring{playback, firstBus, {1'001}, QStringLiteral("night"), replayCatalog()};
    ReplayBus line{playback, firstLine, {1'002}, QStringLiteral("night Gate"), replayCatalog()};
    std::vector<TrafficRow> rows;
    std::vector<Message> messages;
    int restarts = 0;
};

TEST_F(ReplayBusTest, ShowsWhatWasRecordedBitForBit)
{
    showAt(noon + 1'234ms);
    EXPECT_EQ(words().in(), 1'123U);
    EXPECT_EQ(words().out(), 0U);
    EXPECT_EQ(encoder().latest().position, 1'123);
    EXPECT_EQ(encoder().latest().stepsPerSecond, 100.0);
    EXPECT_EQ(encoder().latest().state, EncoderState::operation);
    EXPECT_EQ(encoder(trolley).latest().position, 77);
    EXPECT_EQ(encoder().dateTime(encoder().latest().at).toUTC().time(), QTime(12, 0, 1, 234));
    EXPECT_EQ(words().inWords(), 2);
    EXPECT_EQ(ring.found(replayed(hoist))->deviceKey, QStringLiteral("fraba-ocd-ib"));
}

TEST_F(ReplayBusTest, EachBusOfARecordingHasItsOwnDevices)
{
    EXPECT_EQ(ring.places(), (std::vector{replayed(hoist), replayed(trolley)}));
    EXPECT_EQ(line.places(), std::vector{replayed(atTheGate, 1'002)});
    EXPECT_EQ(line.channel(replayed(atTheGate, 1'002)), nullptr) << "it has no words";
    showAt(noon + 520ms);
    const Reading &reading = line.encoder(replayed(atTheGate, 1'002))->latest();
    EXPECT_EQ(reading.position, 45);
    EXPECT_EQ(reading.state, EncoderState::operation);
    EXPECT_FALSE(ring.trafficColumns().data() == line.trafficColumns().data());
}

TEST_F(ReplayBusTest, IsNeverTakenForTheMachine)
{
    showAt(noon + 1s);
    EXPECT_TRUE(ring.isReplay());
    EXPECT_TRUE(ring.isOpen());
    EXPECT_FALSE(encoder().freshness().isLive());
    EXPECT_TRUE(encoder().freshness().isOld());
    EXPECT_EQ(encoder().freshness().reason(), Freshness::Reason::recorded);
    EXPECT_EQ(words().freshness().reason(), Freshness::Reason::recorded);
    EXPECT_EQ(words().freshness().seen(), noon + 1s);
    EXPECT_TRUE(ring.outline().state(0).isOld);
}

TEST_F(ReplayBusTest, WhatNobodyRecordedIsUnknown)
{
    for (const Instant at : {noon + 2s, noon + 4s, noon + 5'999ms}) {
        showAt(at);
        EXPECT_EQ(encoder().latest().position, std::nullopt);
        EXPECT_EQ(encoder().latest().state, EncoderState::notSeen);
        EXPECT_EQ(encoder().freshness().state(), Freshness::State::unknown);
        EXPECT_EQ(encoder().freshness().reason(), Freshness::Reason::notRecorded);
        EXPECT_EQ(words().in(), 0U);
        EXPECT_EQ(words().freshness().reason(), Freshness::Reason::notRecorded);
        EXPECT_EQ(encoder(trolley).latest().position, 77) << "of the other one it is";
    }
    showAt(noon + 6s);
    EXPECT_EQ(encoder().latest().position, 5'000);
}

TEST_F(ReplayBusTest, BackwardItShowsTheSameAsForward)
{
    showAt(noon + 1s);
    const Reading forward = encoder().latest();
    playback->jumpTo(noon + 1'100ms);
    playback->play(Direction::backward);
    ring.advance(100ms);
    EXPECT_EQ(playback->position(), noon + 1s);
    EXPECT_EQ(encoder().latest(), forward);
}

TEST_F(ReplayBusTest, StepByStepEveryCycleIsSeen)
{
    for (Word in = 1'001; in < 1'050; ++in) {
        ASSERT_TRUE(playback->step(Direction::forward, ring.inRecording(replayed(hoist))));
        ring.pump();
        EXPECT_EQ(words().in(), in);
    }
}

TEST_F(ReplayBusTest, BitsThatChangedMeanwhileAreEdges)
{
    showAt(noon + 100ms); // 1010
    playback->play(Direction::forward);
    ring.advance(40ms); // 1014
    EXPECT_EQ(words().in(), 1'014U);
    EXPECT_EQ(words().inEdges(), 0b111U) << "1010 to 1014";
    showAt(noon + 1s);
    EXPECT_EQ(words().inEdges(), 0U) << "a jump changes no bits";
}

TEST_F(ReplayBusTest, WhatIsKnownIsOfTheDescriptionInForceThen)
{
    showAt(noon + 1s);
    ASSERT_TRUE(encoder().known(Parameter::steps));
    EXPECT_EQ(encoder().known(Parameter::steps)->value, 4'096);
    const EncoderSession *before = &encoder();
    int changes = 0;
    QObject::connect(before, &EncoderSession::knownChanged, &ring, [&changes] { ++changes; });
    showAt(noon + 7s);
    EXPECT_EQ(encoder().known(Parameter::steps)->value, 8'192);
    EXPECT_EQ(&encoder(), before);
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(encoder().known(Parameter::direction), std::nullopt);
}

TEST_F(ReplayBusTest, AnotherDeviceAtThePlaceHasAnotherSession)
{
    RecordingFile file;
    auto writer = file.begin();
    writer->add(RecordedDescription{hoist, noon, frabaWith({})});
    writer->add(positions(noon, 1'000, [](auto) { return 1; }));
    writer->add(RecordedDescription{hoist, noon + 2s, toJson({.key = QStringLiteral("baumer-k3")})});
    writer->add(positions(noon + 2s, 1'000, [](auto) { return 2; }));
    writer->add(RecordedDescription{hoist, noon + 4s, toJson({.key = QStringLiteral("nobody's")})});
    writer->add(turning(hoist, noon + 4s, 100, 3));
    writer->end();
    const std::shared_ptr<Playback> other = Playback::open(file.path).value();
    ReplayBus bus(other, firstBus, {1'003}, QStringLiteral("other"), replayCatalog());
    int changes = 0;
    QObject::connect(&bus, &EncoderBus::nodesChanged, &bus, [&changes] { ++changes; });
    EXPECT_EQ(bus.encoder(hoist.node)->device().key, QStringLiteral("fraba-ocd-ib"));
    other->jumpTo(noon + 4'500ms);
    bus.pump();
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(bus.encoder(hoist.node), nullptr) << "this program does not know it";
    EXPECT_EQ(bus.channel(hoist.node)->in(), 53U) << "its words are shown";
    EXPECT_EQ(bus.found(replayed(hoist, 1'003))->deviceKey, QStringLiteral("nobody's"));
}

TEST_F(ReplayBusTest, NothingIsSent)
{
    showAt(noon + 1s);
    WordChannel &channel = *ring.channel(replayed(hoist));
    EncoderSession &session = *ring.encoder(replayed(hoist));
    channel.stage(0x8000'0000);
    EXPECT_EQ(channel.write().error().id, RefusalId::onlyRecorded);
    EXPECT_EQ(channel.zero().error().id, RefusalId::onlyRecorded);
    EXPECT_EQ(session.start(ReadParameters{}, Pace::byItself).error().id, RefusalId::onlyRecorded);
    EXPECT_EQ(session.planned({ReadParameters{}}).error().id, RefusalId::onlyRecorded);
    EXPECT_EQ(ring.name(replayed(hoist), QStringLiteral("fraba-ocd-ib"), 0, 0).error().id,
              RefusalId::onlyRecorded);
    EXPECT_EQ(ring.canBe(replayed(hoist), session.device()).error().id, RefusalId::onlyRecorded);
    ring.setOperate(true);
    EXPECT_FALSE(ring.isOperating());
    EXPECT_EQ(messages.back().refusal->id, RefusalId::onlyRecorded);
    ring.alarmStop();
    EXPECT_EQ(channel.in(), 1'100U);
    EXPECT_FALSE(session.can().writes || session.can().reads || session.can().presets);
    EXPECT_TRUE(devicesWithOut(ring).empty());
    ring.close();
    EXPECT_FALSE(ring.isOpen());
}

TEST_F(ReplayBusTest, WhatPassedIsToldAsItIsPassed)
{
    playback->play(Direction::forward);
    ring.advance(600ms);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows.front().place, replayed(hoist));
    EXPECT_EQ(rows.front().time.toUTC().time(), QTime(12, 0, 0, 500));
    EXPECT_FALSE(rows.front().meaning().isEmpty());
    ring.advance(100ms);
    EXPECT_EQ(rows.size(), 1U) << "once";
    EXPECT_EQ(restarts, 0);
    showAt(noon + 7'100ms);
    EXPECT_EQ(restarts, 1) << "after a jump it begins with what passed just before";
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows.back().in, 0x80000003U);
    showAt(noon + 6'400ms);
    EXPECT_TRUE(messages.empty());
    ring.advance(200ms);
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages.front().id, MessageId::valuesForgotten);
    EXPECT_EQ(messages.front().place, replayed(hoist));
}

TEST_F(ReplayBusTest, IsNeitherKeptNorRecordedAgain)
{
    Buses buses;
    buses.add(ring);
    const Histories histories(buses);
    BusFeed feed(buses, [] { return QDateTime::currentDateTime(); });
    int came = 0;
    QObject::connect(&feed, &BusFeed::came, &buses, [&came] { ++came; });
    playback->play(Direction::forward);
    ring.advance(7s);
    EXPECT_TRUE(histories.places().empty());
    EXPECT_TRUE(histories.marks().empty());
    EXPECT_EQ(came, 0);
    EXPECT_EQ(buses.open().size(), 1U);
    EXPECT_TRUE(buses.connected().empty());
}

} // namespace
} // namespace codewheel
