// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "history/histories.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "recording/bus_recorder.h"
#include "recording/recorded_device.h"
#include "recording/recording_estimate.h"
#include "tests/recording/server_fixture.h"

#include <QFileInfo>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace test;

const Catalog &builtIn()
{
    static const Catalog catalog = Catalog::builtIn();
    return catalog;
}

const QDateTime connectedAt(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC);

// The training ring and a line beside it, and what is recorded of them.
class BusRecorderTest : public testing::Test
{
protected:
    BusRecorderTest()
    {
        plan.settings = file.settings();
        buses.add(ring);
        buses.add(line);
        EXPECT_TRUE(ring.open(EncoderBus::Start::operating));
        EXPECT_TRUE(line.open({}, {}, EncoderBus::Start::operating, EncoderBus::Drive::byHand));
        EXPECT_TRUE(line.add({5}, QStringLiteral("kuebler-esc-rs485")));
        training.controls->setSpeed(turning.node, 60);
        advance(1s);
    }
    void advance(Instant duration)
    {
        for (Instant passed{}; passed < duration; passed += 33ms) {
            ring.advance(33ms);
            line.advance(33ms);
        }
    }
    std::unique_ptr<BusRecorder> begin()
    {
        auto recorder = BusRecorder::begin(buses, histories, plan, [this] { return wallClock; });
        EXPECT_TRUE(recorder);
        return recorder ? std::move(*recorder) : nullptr;
    }
    Instant now() const { return ring.sinceEpoch(ring.now()); }
    // Of the place, as recorded.
    std::vector<Sample> recorded(Place place, Channel channel = Channel::position) const
    {
        return recorded(file.reader(), place, channel);
    }
    static std::vector<Sample> recorded(const RecordingReader &reader, Place place, Channel channel)
    {
        const auto devices = reader.devices().value();
        for (std::size_t i = 0; i < devices.size(); ++i)
            if (devices[i].place == place) {
                RecordedChannel found = RecordingFile::channel(reader, channel, i);
                return samplesOf(found);
            }
        return {};
    }
    std::vector<Sample> shown(Place place, const TimeSpan &span, Channel channel = Channel::position) const
    {
        std::vector<Sample> samples;
        histories.of(place)->of(channel).forEach(span,
                                                 [&](const Sample &sample) { samples.push_back(sample); });
        return samples;
    }

    void setSteps(std::int64_t steps)
    {
        EXPECT_TRUE(ring.encoder(standing)->start(
            WriteParameters{.values = {{Parameter::steps, steps}}, .previous = {}}));
        advance(5s);
        EXPECT_FALSE(ring.encoder(standing)->runningJob());
    }
    void tellScale()
    {
        for (const auto &[parameter, value] :
             {std::pair(Parameter::startUpMode, 1), {Parameter::steps, 8'192}, {Parameter::revolutions, 1}})
            ring.encoder(standing)->tell(parameter, value);
        advance(1s);
    }
    // Since when there were how many steps per turn, where that is known.
    std::vector<std::pair<Instant, std::int64_t>> recordedSteps() const
    {
        std::vector<std::pair<Instant, std::int64_t>> all;
        const RecordingReader reader = file.reader();
        const auto devices = reader.devices().value();
        const auto device = std::ranges::find(devices, standing, &RecordingReader::Device::place);
        if (device == devices.end())
            return {};
        const auto descriptions = reader.descriptions(*device).value();
        for (const RecordingReader::Description &one : descriptions) {
            const auto steps = valueOf(recordedDeviceFromJson(one.json).known, Parameter::steps);
            if (steps && (all.empty() || all.back().second != *steps))
                all.emplace_back(one.since, *steps);
        }
        return all;
    }

    const Place standing = "1.0"_ring;
    const Place turning = "4.0"_ring;
    const Place onLine = Place{firstLine, NodeId("esc:05")};
    RecordingFile file;
    RecordingPlan plan;
    QDateTime wallClock = connectedAt;
    TrainingBus training = makeTrainingBus(builtIn());
    RingSession ring{std::move(training.link), builtIn(), connectedAt};
    EscLineSession line{std::make_unique<SimulatedEscLineLink>(std::make_shared<SimulatedEscLine>()),
                        builtIn(), connectedAt, [](const DeviceDescription &device, EscLineAddress address) {
                            return std::make_unique<EscDriver>(device, address);
                        }};
    Buses buses;
    Histories histories{buses};
};

TEST_F(BusRecorderTest, EveryCycleAndEveryAnswerOfAllBusesIsRecorded)
{
    const auto recorder = begin();
    EXPECT_EQ(recorder->state(), BusRecorder::State::recording);
    const Instant from = now() + Instant(1);
    advance(2s);
    recorder->end();
    EXPECT_EQ(recorder->state(), BusRecorder::State::ended);
    const TimeSpan span{from, now() + 1s};
    EXPECT_GT(recorded(turning).size(), 1'900U);
    EXPECT_EQ(recorded(turning), shown(turning, span));
    EXPECT_EQ(recorded(turning, Channel::in), shown(turning, span, Channel::in));
    EXPECT_FALSE(recorded(onLine).empty());
    const RecordingReader reader = file.reader();
    EXPECT_EQ(reader.buses()->size(), 2U);
    EXPECT_GT(reader.traffic({from, now() + 1s}, 10'000)->size(), 20U) << "requests and answers";
    const auto descriptions = reader.descriptions(reader.devices()->front()).value();
    ASSERT_FALSE(descriptions.empty());
    EXPECT_TRUE(builtIn().find(recordedDeviceFromJson(descriptions.front().json).key));
}

TEST_F(BusRecorderTest, ABusHasTheNameItIsShownWith)
{
    setBusNames({}, {{ring.id(), QStringLiteral("Crane")}});
    const auto recorder = begin();
    advance(1s);
    recorder->end();
    setBusNames({});
    const auto kept = file.reader().buses().value();
    EXPECT_EQ(std::ranges::find(kept, ring.id(), &RecordedBus::bus)->name, QStringLiteral("Crane"));
}

TEST_F(BusRecorderTest, TheRoomItNeedsIsEstimatedBefore)
{
    const RecordingEstimate estimate(buses, histories);
    advance(10s);
    const double expected = estimate.bytesPerSecond({}, true).value();
    EXPECT_GT(expected, estimate.bytesPerSecond({}, false).value()) << "traffic needs room too";
    EXPECT_GT(estimate.bytesPerSecond({turning}, false).value(), 1'000);
    EXPECT_LT(estimate.bytesPerSecond({"1.0"_ring}, false).value(), 10) << "it stands";
    EXPECT_FALSE(estimate.bytesPerSecond({"9.0"_ring}, true)) << "nothing is there";
    const auto recorder = begin();
    const qint64 before = QFileInfo(plan.settings.file).size();
    advance(20s);
    recorder->end();
    const double actual = static_cast<double>(QFileInfo(plan.settings.file).size() - before) / 20;
    EXPECT_GT(actual, expected / 2);
    EXPECT_LT(actual, expected * 2);
}

TEST_F(BusRecorderTest, WhatBecomesKnownOfAnEncoderIsRecorded)
{
    const auto recorder = begin();
    advance(100ms);
    ring.encoder(turning)->tell(Parameter::steps, 8'192);
    advance(100ms);
    recorder->end();
    const RecordingReader reader = file.reader();
    const auto devices = reader.devices().value();
    for (const auto &device : devices)
        if (device.place == turning) {
            const auto all = reader.descriptions(device).value();
            EXPECT_EQ(valueOf(recordedDeviceFromJson(all.back().json).known, Parameter::steps), 8'192);
            EXPECT_EQ(all.size(), 2U);
        }
}

TEST_F(BusRecorderTest, WhatWasInForceBeforeItBeganIsInItWithItsTime)
{
    tellScale();
    setSteps(4'096);
    const Instant changed = histories.scales(standing).back().from;
    plan.extent.before = 6s;
    const auto recorder = begin();
    advance(200ms);
    const Instant from = recorder->span()->from;
    recorder->end();
    ASSERT_LT(from, changed);
    EXPECT_THAT(recordedSteps(), testing::ElementsAre(std::pair(from, std::int64_t{8'192}),
                                                      std::pair(changed, std::int64_t{4'096})));
}

TEST_F(BusRecorderTest, WhatChangesMeanwhileIsInForceFromTheCycleThatConfirmedIt)
{
    tellScale();
    const auto recorder = begin();
    advance(100ms);
    const Instant from = recorder->span()->from;
    setSteps(4'096);
    recorder->end();
    EXPECT_THAT(recordedSteps(),
                testing::ElementsAre(std::pair(from, std::int64_t{8'192}),
                                     std::pair(histories.scales(standing).back().from, std::int64_t{4'096})));
}

TEST_F(BusRecorderTest, OnlyTheChosenPlacesWithoutTraffic)
{
    plan.places = {turning};
    plan.withTraffic = false;
    const auto recorder = begin();
    advance(500ms);
    recorder->end();
    EXPECT_FALSE(recorded(turning).empty());
    EXPECT_TRUE(recorded("1.0"_ring).empty());
    EXPECT_TRUE(recorded(onLine).empty());
    EXPECT_TRUE(file.reader().traffic({Instant(0), Instant::max()}, 10)->empty());
}

TEST_F(BusRecorderTest, WhenTheTimeIsOverItEnds)
{
    plan.extent.after = 1s;
    const auto recorder = begin();
    int changes = 0;
    QObject::connect(recorder.get(), &BusRecorder::stateChanged, recorder.get(), [&] { ++changes; });
    advance(2s);
    EXPECT_EQ(recorder->state(), BusRecorder::State::ended);
    EXPECT_EQ(changes, 1);
    const auto samples = recorded(turning);
    EXPECT_NEAR(static_cast<double>((samples.back().at - samples.front().at) / 1ms), 999, 2);
    EXPECT_TRUE(file.reader().head()->hasEnded);
}

TEST_F(BusRecorderTest, AThresholdBeginsItWithWhatWasBefore)
{
    const std::int64_t position = *ring.encoder(turning)->latest().position;
    plan.trigger = ThresholdTrigger{turning, Channel::position, position + 6'000, true};
    plan.extent = {500ms, 300ms};
    const auto recorder = begin();
    EXPECT_EQ(recorder->state(), BusRecorder::State::waiting);
    advance(1s);
    EXPECT_EQ(recorder->state(), BusRecorder::State::waiting) << "a turn has 4096 steps";
    advance(2s);
    ASSERT_EQ(recorder->state(), BusRecorder::State::ended);
    const TimeSpan span = *recorder->span();
    EXPECT_EQ(span.to - span.from, Instant(800ms));
    EXPECT_EQ(recorded(turning), shown(turning, span));
    EXPECT_GE(histories.of(turning)->of(Channel::position).at(span.from + 500ms)->value, position + 6'000);
    EXPECT_LT(histories.of(turning)->of(Channel::position).at(span.from + 500ms - 1ms)->value,
              position + 6'000);
    const auto others = recorded(onLine);
    ASSERT_FALSE(others.empty());
    EXPECT_LE(others.front().at, span.from + 100ms);
}

TEST_F(BusRecorderTest, AMessageBeginsItAndIsInIt)
{
    plan.trigger = MessageTrigger{.least = Severity::information};
    plan.extent = {200ms, 200ms};
    const auto recorder = begin();
    advance(500ms);
    ASSERT_EQ(recorder->state(), BusRecorder::State::waiting);
    ring.setRunning(false);
    advance(100ms);
    ring.setRunning(true);
    advance(1s);
    ASSERT_EQ(recorder->state(), BusRecorder::State::ended);
    const auto messages = file.reader().messages({Instant(0), Instant::max()}, 10).value();
    ASSERT_GE(messages.size(), 1U);
    EXPECT_EQ(messages.front().message.code, QStringLiteral("busStopped"));
    EXPECT_EQ(messages.front().at, recorder->span()->from + 200ms);
    EXPECT_GT(recorded(turning).size(), 190U);
}

TEST_F(BusRecorderTest, ByHandItNeedNotWait)
{
    plan.trigger = MessageTrigger{.place = "9.0"_ring};
    plan.extent = {300ms, {}};
    const auto recorder = begin();
    advance(500ms);
    recorder->fire();
    advance(500ms);
    recorder->end();
    EXPECT_EQ(recorded(turning), shown(turning, {recorder->span()->from, now() + 1s}));
    EXPECT_NEAR(static_cast<double>(recorded(turning).size()), 800, 40);
}

TEST_F(BusRecorderTest, WhileABusIsClosedThereIsAGap)
{
    const auto recorder = begin();
    advance(300ms);
    const Instant closed = now();
    ring.close();
    advance(300ms);
    ASSERT_TRUE(ring.open(EncoderBus::Start::watching));
    ring.setTime(connectedAt.addSecs(60));
    advance(300ms);
    recorder->end();
    const RecordingReader reader = file.reader();
    const auto devices = reader.devices().value();
    for (std::size_t i = 0; i < devices.size(); ++i)
        if (devices[i].place == turning) {
            RecordedChannel channel = RecordingFile::channel(reader, Channel::position, i);
            EXPECT_TRUE(channel.at(closed - 10ms).value());
            EXPECT_FALSE(channel.at(closed + 10ms).value());
            EXPECT_GT(channel.span()->to, closed + 10s);
        }
}

TEST_F(BusRecorderTest, ABusThatIsClosedSaysFromWhenOnNothingIsKnown)
{
    BusFeed feed(buses, [this] { return wallClock; });
    std::vector<RecordedInterruption> interruptions;
    QObject::connect(&feed, &BusFeed::came, &feed, [&](const RecordingEntry &entry) {
        if (const auto *interruption = std::get_if<RecordedInterruption>(&entry))
            interruptions.push_back(*interruption);
    });
    advance(300ms);
    ring.close();
    line.close();
    ASSERT_EQ(interruptions.size(), 2U);
    EXPECT_EQ(interruptions[0].place, (Place{firstBus, {}}));
    EXPECT_EQ(interruptions[1].place, (Place{firstLine, {}}));
    EXPECT_NEAR(static_cast<double>(interruptions[0].at / 1ms), static_cast<double>(now() / 1ms), 2);
}

TEST_F(BusRecorderTest, TheClockOfTheComputerIsNotedWhenItIsSet)
{
    wallClock = connectedAt.addSecs(1);
    const auto recorder = begin();
    advance(100ms);
    wallClock = wallClock.addSecs(-3'600);
    advance(100ms); // one moment may be wrong
    advance(100ms);
    advance(100ms);
    recorder->end();
    const WallClock clock = file.reader().clock().value();
    ASSERT_EQ(clock.changes().size(), 2U);
    EXPECT_NEAR(static_cast<double>((now() - clock.wall(now())) / 1s), 3'600, 1);
}

TEST_F(BusRecorderTest, WhatIsWrongWithTheFileIsSaidAtOnce)
{
    file.fill("mine");
    const auto recorder = BusRecorder::begin(buses, histories, plan, [this] { return wallClock; });
    ASSERT_FALSE(recorder);
    EXPECT_EQ(recorder.error().id, RefusalId::recordingExists);
}

TEST_F(BusRecorderTest, AServerTakesItAsAFileDoes)
{
    PostgresServer *server = PostgresServer::shared();
    if (server == nullptr)
        GTEST_SKIP() << noServer;
    server->setPassword(QString::fromLatin1(PostgresServer::password));
    plan.settings.file.clear();
    plan.settings.server = server->newDatabase();
    plan.settings.unsentFolder = file.folder();
    const auto recorder = begin();
    advance(1s);
    const TimeSpan span = recorder->span().value();
    recorder->end();
    const RecordingStatus status = recorder->status();
    EXPECT_FALSE(status.problem);
    const auto reader = RecordingReader::open(status.server->address);
    ASSERT_TRUE(reader);
    EXPECT_TRUE(reader->head()->hasEnded);
    EXPECT_EQ(recorded(*reader, turning, Channel::position), shown(turning, span));
}

TEST_F(BusRecorderTest, ANoteOfTheUserIsInIt)
{
    const auto recorder = begin();
    advance(100ms);
    recorder->note(now(), QStringLiteral("knocked"));
    recorder->end();
    EXPECT_EQ(file.reader().notes({Instant(0), Instant::max()}, 10)->at(0).text, QStringLiteral("knocked"));
}

} // namespace
} // namespace codewheel
