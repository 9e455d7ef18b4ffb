// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_outline.h"
#include "replay/can_log_link.h"
#include "tests/kinds/canopen/bus/canopen_plant.h"
#include "vocabulary/message_items.h"

#include <QFile>
#include <QTemporaryDir>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using canopen::NmtState;

class CanopenBus : public test::CanopenPlant
{};

TEST_F(CanopenBus, WatchSendsNothing)
{
    open(EncoderBus::Start::watching);
    bus->advance(5s);
    EXPECT_TRUE(link->sent.empty());
    EXPECT_EQ(link->uses, std::vector{CanUse::watch});
    EXPECT_TRUE(bus->isRunning());
    EXPECT_FALSE(bus->isOperating());
    EXPECT_FALSE(carryOut(five, ReadParameters{{Parameter::steps}}));
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->id, RefusalId::watchOnly);
    bus->send(test::canFrame(0, {1, 5}));
    bus->scan();
    bus->alarmStop();
    bus->advance(1s);
    EXPECT_TRUE(link->sent.empty());
}

TEST_F(CanopenBus, WhatIsHeardIsShownInWatch)
{
    open(EncoderBus::Start::watching);
    bus->advance(1500ms);
    const CanopenSnapshot::Node *node = bus->latest().heard(6);
    ASSERT_NE(node, nullptr);
    EXPECT_EQ(node->bootUps, 1);
    EXPECT_EQ(node->state, NmtState::preOperational) << "by its heartbeat";
    ASSERT_NE(bus->latest().heard(7), nullptr) << "nobody has added it";
    EXPECT_EQ(bus->outline().state(1).shown.word, QStringLiteral("pre-operational"));
    EXPECT_EQ(bus->latest().status.state, CanState::active);
    EXPECT_GT(bus->latest().figures.received, 3U);
}

TEST_F(CanopenBus, PositionsThatNodesSendAreShownInWatchAsFarAsTheirMappingIsKnown)
{
    open(EncoderBus::Start::watching);
    bus->advance(200ms);
    say(canopen::NmtRequest{canopen::NmtCommand::start, 0}.frame());
    bus->advance(1s);
    ASSERT_NE(bus->latest().heard(5), nullptr);
    EXPECT_EQ(bus->latest().heard(5)->state, NmtState::operational);
    EXPECT_TRUE(bus->latest().heard(5)->sendsPdos);
    EXPECT_FALSE(bus->encoder(five)->latest().position) << "nobody has read what the PDO holds";
    EXPECT_TRUE(link->sent.empty());
}

TEST_F(CanopenBus, NodesAreAskedForTheirPositionsInOperate)
{
    operate();
    ASSERT_TRUE(bus->encoder(five)->latest().position);
    EXPECT_EQ(*bus->encoder(five)->latest().position, 5'000);
    EXPECT_TRUE(bus->encoder(six)->latest().position);
    EXPECT_TRUE(bus->encoder(five)->freshness().isLive());
    EXPECT_GT(sentTo(0x605), 10);
    EXPECT_GT(sentTo(0x606), 10);
    EXPECT_EQ(sentTo(0x607), 0) << "nobody has added it";
    EXPECT_EQ(bus->latest().figures.answersOfOthers, 0U);
    EXPECT_GT(bus->latest().figures.load, 0.01);
    EXPECT_LT(bus->latest().figures.load, 0.5);
    EXPECT_EQ(bus->latest().status.rate, 125'000);
}

TEST_F(CanopenBus, PositionsComeByPdoOnceTheNodeRuns)
{
    operate();
    bus->send(test::canFrame(0, {1, 6}));
    bus->advance(2s);
    const auto asked = [this] {
        return std::ranges::count_if(link->sent, [](const CanFrame &frame) {
            return frame.id == 0x606 && frame.bytes[1] == 0x04 && frame.bytes[2] == 0x60;
        });
    };
    const auto before = asked();
    const auto position = bus->encoder(six)->latest().position;
    bus->advance(2s);
    EXPECT_EQ(asked(), before) << "6004h";
    EXPECT_NE(bus->encoder(six)->latest().position, position) << "its shaft turns";
}

TEST_F(CanopenBus, ValuesAreRead)
{
    operate();
    const auto outcome =
        carryOut(six, ReadParameters{{Parameter::steps, Parameter::measuringRange, Parameter::serialNumber}});
    ASSERT_TRUE(outcome && outcome->result);
    EXPECT_EQ(valueOf(outcome->read, Parameter::serialNumber), 0x0012'D5A4);
    EXPECT_TRUE(bus->encoder(six)->known(Parameter::steps));
}

TEST_F(CanopenBus, ValuesAreWrittenAndReadBack)
{
    operate();
    const auto outcome = carryOut(
        six, WriteParameters{.values = {{Parameter::steps, 3'600}, {Parameter::scaling, 1}}, .previous = {}});
    ASSERT_TRUE(outcome);
    ASSERT_TRUE(outcome->result);
    EXPECT_EQ(valueOf(outcome->written, Parameter::steps), 3'600);
    const auto *object = plant->withEncoder(1, [](canopen::SimulatedNode &node) {
        return node.objects().find({0x6001, 0});
    });
    ASSERT_NE(object, nullptr);
    EXPECT_EQ(object->value, 3'600);
}

TEST_F(CanopenBus, AnEncoderIsSetToItsPreset)
{
    operate();
    plant->withEncoder(1, [](canopen::SimulatedNode &node) { node.shaft().setSpeed(0); });
    bus->advance(300ms);
    const auto outcome = carryOut(six, SetPreset{.value = 1'000});
    ASSERT_TRUE(outcome);
    ASSERT_TRUE(outcome->result);
    bus->advance(500ms);
    EXPECT_EQ(bus->encoder(six)->latest().position, 1'000);
    EXPECT_EQ(std::ranges::count_if(link->sent,
                                    [](const CanFrame &frame) {
                                        return frame.id == 0x606 && frame.bytes[0] == 0x23 &&
                                               frame.bytes[1] == 0x03 && frame.bytes[2] == 0x60;
                                    }),
              1)
        << "a write is never repeated";
}

TEST_F(CanopenBus, EncodersWorkSideBySide)
{
    operate();
    std::vector<Place> ended;
    for (const Place place : {five, six}) {
        QObject::connect(bus->encoder(place), &EncoderSession::finished, bus.get(),
                         [&, place](const Outcome &) { ended.push_back(place); });
        ASSERT_TRUE(bus->encoder(place)->start(ReadParameters{{Parameter::serialNumber}}));
    }
    bus->advance(1s);
    EXPECT_EQ(ended.size(), 2U);
}

TEST_F(CanopenBus, StoppedNobodyIsAsked)
{
    operate();
    bus->setRunning(false);
    bus->advance(100ms);
    const auto sent = link->sent.size();
    bus->advance(2s);
    EXPECT_EQ(link->sent.size(), sent);
    EXPECT_FALSE(carryOut(five, ReadParameters{{Parameter::serialNumber}}));
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->id, RefusalId::notRunning);
    bus->setRunning(true);
    bus->advance(1s);
    EXPECT_GT(link->sent.size(), sent);
}

TEST_F(CanopenBus, BackInWatchItFallsSilent)
{
    operate();
    bus->setOperate(false);
    bus->advance(10ms);
    const auto sent = link->sent.size();
    bus->advance(2s);
    EXPECT_EQ(link->sent.size(), sent);
    EXPECT_EQ(link->uses.back(), CanUse::watch);
    EXPECT_EQ(countOf(MessageId::watchOn), 1);
    bus->setOperate(true);
    bus->advance(1s);
    EXPECT_EQ(link->uses.back(), CanUse::operate);
    EXPECT_GT(link->sent.size(), sent);
    EXPECT_TRUE(bus->encoder(five)->freshness().isLive());
}

TEST_F(CanopenBus, EncodersAreAddedNamedAndRemoved)
{
    operate();
    EXPECT_EQ(bus->places(), (std::vector{five, six}));
    EXPECT_FALSE(bus->add(5, QStringLiteral("canopen-406-multi-turn"))) << "taken";
    EXPECT_FALSE(bus->add(128, QStringLiteral("canopen-406-multi-turn")));
    EXPECT_FALSE(bus->add(9, QStringLiteral("kuebler-esc-rs485"))) << "of another bus";
    EXPECT_TRUE(bus->name(five, QStringLiteral("canopen-406-multi-turn")));
    bus->advance(1s);
    EXPECT_EQ(bus->encoder(five)->device().key, QStringLiteral("canopen-406-multi-turn"));
    EXPECT_TRUE(bus->encoder(five)->latest().position);
    EXPECT_TRUE(bus->remove(five));
    bus->advance(100ms);
    const int asked = sentTo(0x605);
    bus->advance(1s);
    EXPECT_EQ(sentTo(0x605), asked);
    EXPECT_EQ(bus->places(), std::vector{six});
    EXPECT_TRUE(bus->strangers({{.number = five.node, .deviceKey = {}}}).contains(five.node));
}

TEST_F(CanopenBus, ItsThreadIsHidden)
{
    plant = std::make_unique<canopen::SimulatedCanopenPlant>();
    const auto begin = std::chrono::steady_clock::now();
    CanopenSession threaded(std::make_unique<SimulatedCanLink>(plant->bus(), 125'000,
                                                               [begin] {
                                                                   return std::chrono::duration_cast<Instant>(
                                                                       std::chrono::steady_clock::now() -
                                                                       begin);
                                                               }),
                            catalog, QDateTime(QDate(2026, 11, 21), QTime(12, 0)));
    ASSERT_TRUE(threaded.open({}, EncoderBus::Start::operating, EncoderBus::Drive::byThread));
    ASSERT_TRUE(threaded.add(5, QStringLiteral("canopen-406-single-turn")));
    const auto end = begin + 60s;
    while (!threaded.encoder(five)->latest().position && std::chrono::steady_clock::now() < end)
        threaded.pump();
    EXPECT_EQ(threaded.encoder(five)->latest().position, 5'000);
    threaded.close();
    EXPECT_EQ(threaded.state(), BusState::closed);
}

// It is added once the log is open.
TEST(CanopenLog, ItsFirstFrameIsHeardByTheEncoderThatIsAdded)
{
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("one.log")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("(1544106679.000000) can0 185#88130000\n");
    file.close();
    const Catalog catalog = Catalog::builtIn();
    CanopenSession session(std::make_unique<CanLogLink>(file.fileName(), std::string()), catalog,
                           QDateTime(QDate(2018, 12, 6), QTime(14, 31, 19)));
    session.takeUsualMapping();
    ASSERT_TRUE(session.open({}, EncoderBus::Start::watching, EncoderBus::Drive::byHand));
    ASSERT_TRUE(session.add(5, QStringLiteral("canopen-406-multi-turn")));
    std::vector<std::int64_t> positions;
    QObject::connect(&session, &EncoderBus::updated, &session, [&] {
        const auto *encoder = session.encoder(NodeId("can:5"));
        if (encoder != nullptr && encoder->latest().position)
            positions.push_back(*encoder->latest().position);
    });
    session.advance(1s);
    ASSERT_FALSE(positions.empty());
    EXPECT_EQ(positions.front(), 5000);
}

// The rate of some adapters is not sure.
TEST_F(CanopenBus, WhatIsToBeSaidOfItsLinkIsSaidOnce)
{
    link->remarked = Refusal{RefusalKind::link, CanRefusalId::rateMayBe750, {QStringLiteral("ttyACM0")}};
    operate();
    bus->setOperate(false);
    bus->advance(100ms);
    bus->setOperate(true);
    bus->advance(100ms);
    EXPECT_EQ(std::ranges::count_if(messages,
                                    [](const Message &message) {
                                        return message.refusal &&
                                               message.refusal->id == CanRefusalId::rateMayBe750;
                                    }),
              1);
}

} // namespace
} // namespace codewheel
