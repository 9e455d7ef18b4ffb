// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/canopen_messages.h"
#include "tests/kinds/canopen/driver/driver_bench.h"

#include <gtest/gtest.h>

namespace codewheel::canopen {
namespace {

using namespace std::chrono_literals;

// TPDO 1 has the position and the speed, in this order.
void mapPositionAndSpeed(DriverBench &bench)
{
    bench.has["1800:1"] = {0x85, 0x01, 0, 0x40};
    bench.has["1800:2"] = {0xFE};
    bench.has["1A00:0"] = {2};
    bench.has["1A00:1"] = {0x20, 0, 0x04, 0x60};
    bench.has["1A00:2"] = {0x10, 0x01, 0x30, 0x60};
}

TEST(NodeDriver, IsMadeForItsProfileOnly)
{
    const Catalog catalog = Catalog::builtIn();
    EXPECT_NE(makeNodeDriver(*catalog.find(u"canopen-406-single-turn"), 5), nullptr);
    EXPECT_EQ(makeNodeDriver(*catalog.find(u"kuebler-esc-rs485"), 5), nullptr);
}

TEST(NodeDriver, AsksForThePositionWhereNoPdoBringsIt)
{
    DriverBench bench;
    bench.settle();
    EXPECT_EQ(bench.driver.reading().position, 5000);
    EXPECT_EQ(bench.driver.reading().alarms, 0);
    EXPECT_EQ(bench.value(Parameter::serialNumber), 12345);
    bench.run(1s);
    EXPECT_GE(std::ranges::count(bench.log, std::string("6004:0")), 9);
    EXPECT_LE(std::ranges::count(bench.log, std::string("6004:0")), 11);
    EXPECT_EQ(std::ranges::count(bench.log, std::string("6503:0")), 1);
    EXPECT_EQ(std::ranges::count(bench.log, std::string("1800:1")), 0) << "what it has is known";
}

// As in Watch, and in a log.
TEST(NodeDriver, TakesThePositionByAMappingThatOthersRead)
{
    DriverBench bench;
    bench.hear(0x185, {0x10, 0x27, 0, 0});
    EXPECT_FALSE(bench.driver.reading().position);
    constexpr std::array<std::uint8_t, 8> answers[] = {
        {0x43, 0x00, 0x18, 1, 0x85, 0x01, 0, 0},
        {0x4F, 0x00, 0x1A, 0, 1, 0, 0, 0},
        {0x43, 0x00, 0x1A, 1, 0x20, 0, 0x04, 0x60},
    };
    for (const auto &octets : answers)
        bench.driver.hear(*SdoFrame::answer(octets));
    bench.hear(0x185, {0x11, 0x27, 0, 0});
    EXPECT_EQ(bench.driver.reading().position, 10001);
    bench.hear(0x705, {0}); // it may map something else now
    bench.hear(0x185, {0x12, 0x27, 0, 0});
    EXPECT_NE(bench.driver.reading().position, 10002);
}

TEST(NodeDriver, TakesTheUsualMappingOnlyOnTheUsersWord)
{
    DriverBench bench;
    bench.driver.takeUsualMapping();
    bench.hear(0x185, {0x10, 0x27, 0, 0});
    EXPECT_EQ(bench.driver.reading().position, 10000);
    bench.hear(0x285, {0x11, 0x27, 0, 0});
    bench.hear(0x185, {0x12, 0x27});
    EXPECT_EQ(bench.driver.reading().position, 10000) << "another PDO, and a short one";
}

TEST(NodeDriver, TakesThePositionByTheMappingThatWasRead)
{
    DriverBench bench;
    mapPositionAndSpeed(bench);
    bench.settle();
    bench.hear(0x705, {0x05});
    for (int i = 0; i < 100; ++i) {
        bench.hear(0x185, {0x10, 0x27, 0, 0, 0, 0});
        bench.run(20ms);
    }
    EXPECT_EQ(bench.driver.reading().position, 10000);
    EXPECT_EQ(bench.driver.reading().state, EncoderState::operation);
    EXPECT_EQ(std::ranges::count(bench.log, std::string("6004:0")), 0);
    bench.log.clear();
    bench.run(3s);
    EXPECT_GT(std::ranges::count(bench.log, std::string("6004:0")), 10) << "no PDO comes any more";
}

TEST(NodeDriver, AnotherLayoutIsDecodedAsItIs)
{
    DriverBench bench;
    bench.has["1800:1"] = {0x00, 0x03, 0, 0x40}; // 300h
    bench.has["1A00:0"] = {2};
    bench.has["1A00:1"] = {0x10, 0, 0x05, 0x65};
    bench.has["1A00:2"] = {0x20, 0, 0x04, 0x60};
    bench.settle();
    bench.hear(0x300, {0x02, 0x00, 0x10, 0x27, 0, 0});
    EXPECT_EQ(bench.driver.reading().position, 10000);
    EXPECT_EQ(bench.driver.reading().warnings, 2);
    bench.hear(0x185, {0x01, 0, 0, 0, 0, 0});
    EXPECT_EQ(bench.driver.reading().position, 10000) << "no PDO of this encoder";
}

TEST(NodeDriver, AnEntryThatDoesNotFitItsObjectIsNotDecoded)
{
    DriverBench bench;
    bench.has["1800:1"] = {0x85, 0x01, 0, 0x40};
    bench.has["1A00:0"] = {1};
    bench.has["1A00:1"] = {0x10, 0, 0x04, 0x60}; // 16 bits of 32
    bench.settle();
    bench.hear(0x185, {0x10, 0x27});
    EXPECT_EQ(bench.driver.reading().position, 5000);
}

TEST(NodeDriver, ASpeedThatContradictsThePositionIsToldOnce)
{
    for (const bool isZero : {true, false}) {
        DriverBench bench;
        mapPositionAndSpeed(bench);
        bench.settle();
        bench.finish(ReadParameters{
            {Parameter::steps, Parameter::measuringRange, Parameter::scaling, Parameter::direction}});
        const std::uint8_t speed = isZero ? 0x00 : 0xFF; // -1
        for (int i = 0; i < 200; ++i) {
            bench.hear(0x185, {static_cast<std::uint8_t>(i), 0, 0, 0, speed, speed});
            bench.run(10ms);
        }
        EXPECT_EQ(bench.countOf(CanopenMessageId::speedStandsStill), isZero ? 1 : 0);
        EXPECT_EQ(bench.countOf(CanopenMessageId::speedIsOpposite), isZero ? 0 : 1);
    }
}

TEST(NodeDriver, AnObjectThatIsNotThereIsAskedForOnce)
{
    DriverBench bench;
    bench.has.erase("6505:0");
    bench.settle();
    bench.run(5s);
    EXPECT_EQ(std::ranges::count(bench.log, std::string("6505:0")), 0);
    EXPECT_GE(std::ranges::count(bench.log, std::string("6503:0")), 4);
    EXPECT_FALSE(bench.driver.reading().warnings);
}

TEST(NodeDriver, ShowsAPositionInPreOperational)
{
    DriverBench bench;
    bench.hear(0x705, {0x7F});
    bench.settle();
    EXPECT_EQ(bench.driver.reading().state, EncoderState::waiting);
    EXPECT_EQ(bench.driver.reading().position, 5000);
}

TEST(NodeDriver, AnUnaskedBootUpIsToldAndWhatWasNotStoredIsForgotten)
{
    DriverBench bench;
    bench.settle();
    bench.finish(WriteParameters{.values = {{Parameter::steps, 4000}}, .previous = {}}); // and stored
    bench.finish(ReadParameters{{Parameter::measuringRange}});
    bench.log.clear();
    bench.hear(0x705, {0x00});
    bench.run(200ms);
    EXPECT_EQ(bench.countOf(CanopenMessageId::nodeBooted), 1);
    EXPECT_EQ(bench.value(Parameter::steps), 4000);
    EXPECT_FALSE(bench.value(Parameter::measuringRange));
    EXPECT_GT(std::ranges::count(bench.log, std::string("1800:1")), 0) << "its PDOs may be others";
}

TEST(NodeDriver, EmergenciesAreTold)
{
    DriverBench bench;
    bench.settle();
    bench.hear(0x085, {0x10, 0x43, 0x09, 0, 0, 0, 0, 0});
    bench.hear(0x086, {0x10, 0x43, 0x09, 0, 0, 0, 0, 0}); // of another node
    ASSERT_EQ(bench.countOf(CanopenMessageId::emergency), 1);
    EXPECT_EQ(bench.messages.front().arguments, (std::vector<RefusalArgument>{Word{0x4310}, Word{0x09}}));
    bench.hear(0x085, {0, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(bench.countOf(CanopenMessageId::emergencyGone), 1);
}

// Stored ones may be of the number that it had before.
TEST(NodeDriver, IdentifiersThatAreNotThoseOfItsNumberAreTold)
{
    DriverBench bench;
    bench.has["1005:0"] = {0x80, 0, 0, 0x40};    // it sends SYNC
    bench.has["1014:0"] = {0x88, 0, 0, 0};       // of node 8
    bench.has["1200:1"] = {0x05, 0x06, 0, 0x80}; // off
    bench.has["1800:1"] = {0x88, 0x01, 0, 0x40}; // of node 8
    bench.has["1801:1"] = {0xA7, 0x01, 0, 0};    // TPDO1 of node 39
    bench.has["1802:1"] = {0x85, 0x03, 0, 0};    // its own
    bench.run(5s);
    const auto kept = bench.driver.keptIdentifiers();
    EXPECT_EQ((std::vector<KeptIdentifier>{kept.begin(), kept.end()}),
              (std::vector<KeptIdentifier>{
                  {{0x1800, 1}, 0x188, 0x185}, {{0x1801, 1}, 0x1A7, 0x285}, {{0x1014, 0}, 0x88, 0x85}}));
    EXPECT_EQ(bench.countOf(CanopenMessageId::identifierKept), 3);
    bench.hear(0x705, {0});
    bench.run(5s);
    EXPECT_EQ(bench.countOf(CanopenMessageId::identifierKept), 3) << "each once";
    bench.has["1014:0"] = {0x85, 0, 0, 0};
    bench.driver.observe({.node = 5, .object = {0x1014, 0}, .value = bench.has["1014:0"]},
                         {.kind = SdoOutcome::Kind::written}, bench.now);
    bench.run(5s);
    EXPECT_EQ(bench.driver.keptIdentifiers().size(), 2U);
}

TEST(NodeDriver, SilenceAndItsEndAreToldOnce)
{
    DriverBench bench;
    bench.settle();
    for (int i = 0; i < 6; ++i)
        for (const char *object : {"6004:0", "6503:0", "6505:0"})
            bench.next(object, DriverBench::Fate::lost);
    bench.run(10s);
    EXPECT_EQ(bench.driver.reading().state, EncoderState::silent);
    EXPECT_EQ(bench.countOf(MessageId::encoderSilent), 1);
    bench.run(60s);
    EXPECT_EQ(bench.countOf(MessageId::encoderAnswers), 1);
    EXPECT_EQ(bench.driver.reading().state, EncoderState::waiting);
}

TEST(NodeDriver, AnotherSerialNumberIsAnotherEncoder)
{
    DriverBench bench;
    bench.settle();
    bench.finish(ReadParameters{{Parameter::steps}});
    bench.has["1018:4"] = {1, 0, 0, 0};
    bench.hear(0x705, {0x00});
    bench.run(1s);
    EXPECT_EQ(bench.value(Parameter::serialNumber), 1);
    EXPECT_FALSE(bench.value(Parameter::steps));
}

TEST(NodeDriver, CommandsOfAnotherMasterAreHeeded)
{
    DriverBench bench;
    bench.settle();
    bench.hear(0x000, {0x01, 0x00});
    EXPECT_EQ(bench.driver.state(), NmtState::operational);
    bench.hear(0x000, {0x02, 0x06});
    EXPECT_EQ(bench.driver.state(), NmtState::operational) << "for another node";
    bench.hear(0x000, {0x02, 0x05});
    EXPECT_EQ(bench.driver.reading().state, EncoderState::waiting);
}

TEST(NodeDriver, WhatItDoesNotAnswerForIsAskedForOnce)
{
    DriverBench bench;
    for (int i = 0; i < 100; ++i)
        for (const char *object : {"1800:1", "1A00:0", "1801:1"})
            bench.next(object, DriverBench::Fate::lost);
    bench.run(10s);
    EXPECT_EQ(std::ranges::count(bench.log, std::string("1800:1")), 1);
    EXPECT_EQ(bench.driver.reading().position, 5000);
    EXPECT_EQ(bench.value(Parameter::serialNumber), 12345);
    EXPECT_EQ(bench.countOf(MessageId::encoderSilent), 0);
}

void writeByHand(DriverBench &bench, SdoObject object, std::vector<std::uint8_t> value,
                 SdoOutcome::Kind ended = SdoOutcome::Kind::written)
{
    bench.driver.observe({.node = 5, .object = object, .value = std::move(value)}, {.kind = ended},
                         bench.now);
    bench.run(1ms);
}

TEST(NodeDriver, WhatIsWrittenByHandIsNotKnownAnyMore)
{
    DriverBench bench;
    bench.settle();
    const std::vector<Parameter> all{Parameter::steps, Parameter::direction, Parameter::measuringRange,
                                     Parameter::offset};
    bench.finish(ReadParameters{all});
    writeByHand(bench, {0x6001, 0}, {1, 0, 0, 0}, SdoOutcome::Kind::aborted);
    EXPECT_TRUE(bench.value(Parameter::steps)) << "it was refused";
    writeByHand(bench, {0x6001, 0}, {1, 0, 0, 0}, SdoOutcome::Kind::noAnswer);
    EXPECT_FALSE(bench.value(Parameter::steps));
    EXPECT_FALSE(bench.value(Parameter::offset)) << "it follows";
    EXPECT_TRUE(bench.value(Parameter::direction));
    bench.finish(ReadParameters{all});
    writeByHand(bench, {0x6003, 0}, {0, 0, 0, 0});
    EXPECT_FALSE(bench.value(Parameter::offset)) << "the position was set";
    bench.driver.hear(
        *SdoFrame::request(std::array<std::uint8_t, 8>{0x2B, 0x00, 0x60, 0})); // of another master
    bench.run(1ms);
    EXPECT_FALSE(bench.value(Parameter::direction));
    bench.finish(ReadParameters{all});
    writeByHand(bench, {0x1010, 1}, {0x73, 0x61, 0x76, 0x65});
    EXPECT_EQ(bench.kept(Parameter::steps), Kept::stored);
    writeByHand(bench, {0x1011, 1}, {0x6C, 0x6F, 0x61, 0x64});
    EXPECT_FALSE(bench.value(Parameter::steps));
}

TEST(NodeDriver, AMappingWrittenByHandIsReadAnew)
{
    DriverBench bench;
    mapPositionAndSpeed(bench);
    bench.settle();
    bench.has["1A00:0"] = {1};
    bench.has["1A00:1"] = {0x10, 0, 0x05, 0x65};
    writeByHand(bench, {0x1A00, 1}, {0x10, 0, 0x05, 0x65});
    bench.hear(0x185, {0x10, 0x27, 0, 0, 0, 0});
    EXPECT_NE(bench.driver.reading().position, 10000) << "by the old mapping";
    bench.run(1s);
    bench.hear(0x185, {0x02, 0});
    EXPECT_EQ(bench.driver.reading().warnings, 2);
}

} // namespace
} // namespace codewheel::canopen
