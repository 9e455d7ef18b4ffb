// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/word_refusals.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// FRABA manual 10.2: answer A0000000 + value without the number, as long as 2021xxxx is in OUT; then 00000000
TEST(K3Read, EachReadOutEndsBeforeTheNextBegins)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(ReadParameters{{Parameter::revolutions, Parameter::preset}}));
    table.play({
        {0x0000'0000, pos},
        {0x2021'0002, pos},
        {0x2021'0002, pos},
        {0x2021'0002, 0xA000'0001},
        {0x0000'0000, 0xA000'0001},
        {0x0000'0000, 0xA000'0001}, // still the old answer: not that of the next read-out
        {0x0000'0000, pos},
        {0x2021'0004, pos},
        {0x2021'0004, 0xA000'0064},
        {0x0000'0000, 0xA000'0064},
        {0x0000'0000, pos},
        {0x0000'0000, pos},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->read,
              (ParameterValues{{Parameter::revolutions, 1}, {Parameter::preset, 100}}));
    EXPECT_EQ(table.outcome()->eepromWrites, 0);
    EXPECT_EQ(table.evidence(Parameter::preset), Evidence::read);
}

struct ReadOutRow
{
    const char *name;
    Parameter parameter;
    Word request;
    Word answer;
    std::int64_t value;
};

class FrabaReadOut : public testing::TestWithParam<ReadOutRow>
{};

TEST_P(FrabaReadOut, GivesTheValue)
{
    DriverTable table(u"fraba-ocd-ib");
    table.tell(Parameter::multiTurnAndStepsMinusOne, 2);
    ASSERT_TRUE(table.begin(ReadParameters{{GetParam().parameter}}));
    table.play({{0x0000'0000, pos},
                {GetParam().request, pos},
                {GetParam().request, GetParam().answer},
                {0x0000'0000, pos}});
    EXPECT_EQ(table.known(GetParam().parameter), GetParam().value);
}

// FRABA manual 10.2
INSTANTIATE_TEST_SUITE_P(
    Manual102, FrabaReadOut,
    testing::Values(ReadOutRow{"serialNumber", Parameter::serialNumber, 0x2021'0000, 0xA001'E240, 123'456},
                    ReadOutRow{"steps", Parameter::steps, 0x2021'0001, 0xA000'2000, 8192},
                    ReadOutRow{"revolutions", Parameter::revolutions, 0x2021'0002, 0xA000'0001, 1},
                    ReadOutRow{"complementAsWritten", Parameter::direction, 0x2021'0003, 0xA000'0004, 4},
                    ReadOutRow{"complementAsFlag", Parameter::direction, 0x2021'0003, 0xA000'0001, 4},
                    ReadOutRow{"complementAsFlagOff", Parameter::direction, 0x2021'0003, 0xA000'0000, 3},
                    ReadOutRow{"zeroOffset", Parameter::zeroOffset, 0x2021'0005, 0xA100'0000, 0x100'0000},
                    ReadOutRow{"presetFlag", Parameter::presetFlag, 0x2021'0006, 0xA000'0001, 1},
                    ReadOutRow{"version", Parameter::softwareVersion, 0x2021'0007, 0xA000'000B, 11},
                    ReadOutRow{"operatingTime", Parameter::operatingTime, 0x2021'0008, 0xA000'0090, 144},
                    ReadOutRow{"startUpMode", Parameter::startUpMode, 0x2021'0009, 0xA000'0001, 1},
                    ReadOutRow{"temperature", Parameter::temperature, 0x2021'000C, 0xA000'00F5, 245},
                    ReadOutRow{"frost16Bit", Parameter::temperature, 0x2021'000C, 0xA000'FFCE, -50},
                    ReadOutRow{"frost25Bit", Parameter::temperature, 0x2021'000C, 0xA1FF'FFCE, -50}),
    [](const auto &row) { return row.param.name; });

TEST(K3Read, StepsAreReadAfterTheFlagThatSaysHowTheyCount)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(ReadParameters{{Parameter::steps}}));
    table.play({{0x0000'0000, pos},
                {0x2021'000A, pos},
                {0x2021'000A, 0xA000'0003},
                {0x0000'0000, pos},
                {0x2021'0001, pos},
                {0x2021'0001, 0xA000'0FFF},
                {0x0000'0000, pos}});
    EXPECT_EQ(table.known(Parameter::steps), 4096);
}

// FRABA manual 10.3: A4xxxxxx
TEST(K3Read, AnUnknownReadOutIsNamed)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(ReadParameters{{Parameter::temperature}}));
    table.play({{0x0000'0000, pos},
                {0x2021'000C, pos},
                {0x2021'000C, 0xA400'000C},
                {0x0000'0000, 0xA400'000C},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(
        table.outcome()->result.error(),
        (Refusal{RefusalKind::device, WordRefusalId::readOutUnknown, {std::int64_t{12}, Word{0xA400'000C}}}));
}

TEST(K3Read, AnEncoderThatDoesNotAnswerTimesOutAndOutIsClearedAgain)
{
    DriverTable table(u"fraba-ocd-ib", {.settle = Instant{0}, .timeOut = std::chrono::milliseconds(10)});
    ASSERT_TRUE(table.begin(ReadParameters{{Parameter::preset}}));
    table.play({{0x0000'0000, pos}});
    table.repeat(10, {0x2021'0004, pos});
    table.repeat(2, {0x0000'0000, pos});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error().arguments,
              (std::vector<RefusalArgument>{0.01, Word{0x2021'0004}, Word{pos}}));
}

// "An A word nobody asked for is the self test"
TEST(K3Read, TheSelfTestIsWaitedForAndNotTakenForAnAnswer)
{
    DriverTable table(u"fraba-ocd-ib");
    table.play({{0x0000'0000, 0xA000'0007}});
    ASSERT_TRUE(table.begin(ReadParameters{{Parameter::preset}}));
    table.play({{0x0000'0000, 0xA000'0007},
                {0x0000'0000, 0xA000'0007},
                {0x0000'0000, pos},
                {0x2021'0004, pos},
                {0x2021'0004, 0xA000'0000},
                {0x0000'0000, pos}});
    EXPECT_EQ(table.known(Parameter::preset), 0);
}

// Behind a gateway the serial number may come as the high half of the answer and the low half of the
// position. It decides which encoder the EEPROM writes are counted for.
class TornReads : public testing::Test
{
protected:
    TornReads()
    {
        table.driver().expectTornWords();
        EXPECT_TRUE(table.begin(ReadParameters{{Parameter::serialNumber}}));
        table.play({{0x0000'0000, pos}});
    }
    // Asks, and holds the answer for as long as it takes to count.
    void ask(Word what, Word answer)
    {
        table.play({{what, pos}});
        table.repeat(standing, {what, answer});
        table.play({{0x0000'0000, pos}});
    }

    static constexpr int standing = 51; // ms
    static constexpr Word serialNumber = 0x2021'0000;
    static constexpr Word another = 0x2021'0001;
    static constexpr Word halfOfPosition = 0xA000'3039;
    DriverTable table{u"fraba-ocd-ib"};
};

TEST_F(TornReads, AnAnswerCountsOnceItHasStood)
{
    table.play({{serialNumber, pos}});
    table.repeat(20, {serialNumber, halfOfPosition}); // the low half is copied 20 ms later
    table.repeat(50, {serialNumber, 0xA000'4FC1});
    EXPECT_FALSE(table.outcome());
    EXPECT_EQ(table.known(Parameter::serialNumber), std::nullopt);
    table.play({{serialNumber, 0xA000'4FC1}, {0x0000'0000, pos}, {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome() && table.outcome()->result);
    EXPECT_EQ(table.known(Parameter::serialNumber), 20417);
}

TEST_F(TornReads, AnAnswerWithHalfOfThePositionIsAskedForAgainBehindAnother)
{
    ask(serialNumber, halfOfPosition);
    EXPECT_EQ(table.known(Parameter::serialNumber), std::nullopt);
    ask(another, 0xA000'2000);
    ask(serialNumber, 0xA000'4FC1);
    table.play({{0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome() && table.outcome()->result);
    EXPECT_EQ(table.outcome()->read, (ParameterValues{{Parameter::serialNumber, 20417}}));
    EXPECT_EQ(table.known(Parameter::serialNumber), 20417);
}

// It is really half of the position. The one between is, too: it is not learned, and the other not forgotten.
TEST_F(TornReads, TheSameAnswerTwiceCounts)
{
    ask(serialNumber, halfOfPosition);
    ask(another, 0xA000'3039);
    ask(serialNumber, halfOfPosition);
    table.play({{0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome() && table.outcome()->result);
    EXPECT_EQ(table.known(Parameter::serialNumber), 12345);
    EXPECT_EQ(table.known(Parameter::steps), std::nullopt);
}

TEST_F(TornReads, AnswersThatNeverAgreeAreNotBelievedNorAskedForEver)
{
    constexpr int times = 5;
    for (Word upper = 1; upper <= times; ++upper) { // 98361, 12345 + 2 * 65536 ...
        ask(serialNumber, halfOfPosition | upper << 16);
        if (upper < times)
            ask(another, 0xA000'2000);
    }
    table.play({{0x0000'0000, pos}, {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error().id, WordRefusalId::wordsTorn);
    EXPECT_EQ(table.known(Parameter::serialNumber), std::nullopt);
}

} // namespace
} // namespace codewheel
