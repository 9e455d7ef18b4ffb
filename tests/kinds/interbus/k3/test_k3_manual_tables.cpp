// SPDX-License-Identifier: GPL-3.0-or-later
// The manuals' own tables, row by row and with the delay of a real encoder, as the user's words.
#include "kinds/interbus/words/word_refusals.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr Word newPos = 0x0000'0180;

const std::vector<Word> manualWords{0x0200'00FF, 0x0400'0001, 0x0600'0003,
                                    0x0800'0000, 0x8000'0000, 0x0000'0000};

// FRABA manual 5.3: 255 steps, 1 revolution, clockwise, preset 0
TEST(FrabaManual53, WordsFollowEachOtherAsInTheTable)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(SendWords{.words = manualWords, .holdCycles = 1}));
    table.play({
        {0x0000'0000, pos},         // 1
        {0x0200'00FF, pos},         // 2-3
        {0x0200'00FF, 0xC200'00FF}, // 4-6
        {0x0400'0001, 0xC200'00FF}, // 4': old confirmation
        {0x0400'0001, 0xC400'0001}, // 5'-6'
        {0x0600'0003, 0xC400'0001}, // 4''
        {0x0600'0003, 0xC600'0003}, // 5''-6''
        {0x0800'0000, 0xC600'0003}, // 4'''
        {0x0800'0000, 0xC800'0000}, // 5'''-6'''
        {0x8000'0000, 0xC800'0000}, // 7
        {0x8000'0000, pos},         // 8
        {0x0000'0000, newPos},      // 9
        {0x0000'0000, newPos},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->eepromWrites, 4);
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::operation);
}

TEST(FrabaManual53, CycleByCycleWithTwoCyclesOfDelay)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(SendWords{.words = manualWords}));
    table.play({
        {0x0000'0000, pos},         {0x0200'00FF, pos},         {0x0200'00FF, pos},
        {0x0200'00FF, 0xC200'00FF}, {0x0400'0001, 0xC200'00FF}, {0x0400'0001, 0xC200'00FF},
        {0x0400'0001, 0xC400'0001}, {0x0600'0003, 0xC400'0001}, {0x0600'0003, 0xC400'0001},
        {0x0600'0003, 0xC600'0003}, {0x0800'0000, 0xC600'0003}, {0x0800'0000, 0xC600'0003},
        {0x0800'0000, 0xC800'0000}, {0x8000'0000, 0xC800'0000}, {0x8000'0000, pos},
        {0x0000'0000, newPos},      {0x0000'0000, newPos},      {0x0000'0000, newPos},
        {0x0000'0000, newPos},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

// FRABA manual 5.3, generic rows 4-5, and 10.4: "processing" as operation or as C0xxxxxx is waited out
TEST(FrabaManual53, ProcessingIsNoConfirmation)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(SendWords{.words = {0x0200'00FF, 0x8000'0000}}));
    table.play({
        {0x0000'0000, pos},
        {0x0200'00FF, 0x0000'0000},
        {0x0200'00FF, 0xC000'00FF},
        {0x0200'00FF, 0xC000'00FF},
        {0x0200'00FF, 0xC200'00FF},
        {0x8000'0000, 0xC200'00FF},
        {0x8000'0000, newPos},
        {0x8000'0000, newPos},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

// FRABA manual 5.3, preset
TEST(FrabaManual53, PresetIsInitialisedByBit30)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(SendWords{.words = {0x4000'0000, 0x0000'0000}, .holdCycles = 2}));
    table.play({{0x0000'0000, pos},
                {0x4000'0000, pos},
                {0x4000'0000, 0x0000'0000},
                {0x0000'0000, 0x0000'0000},
                {0x0000'0000, 0x0000'0000},
                {0x0000'0000, 0x0000'0000}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

// Baumer manual 6, example 2: 20 000 revolutions do not harmonize, so disturbance 1 at run
TEST(BaumerManualExample2, DisturbanceAtRunEndsTheWords)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(table.begin(SendWords{.words = {0x0400'4E20, 0x0600'0001, 0x8000'0000, 0x0000'0000}}));
    table.play({
        {0x0000'0000, pos},
        {0x0400'4E20, pos},
        {0x0400'4E20, pos},
        {0x0400'4E20, 0xC000'4E20}, // processing under the previous number 0
        {0x0400'4E20, 0xC000'4E20},
        {0x0400'4E20, 0xC400'4E20},
        {0x0600'0001, 0xC400'4E20}, // old
        {0x0600'0001, 0xC400'4E20},
        {0x0600'0001, 0xC400'0001}, // processing
        {0x0600'0001, 0xC600'0001},
        {0x8000'0000, 0xC600'0001},
        {0x8000'0000, 0x8200'0000},
        {0x8000'0000, 0x8200'0000}, // the user's words end here: nothing else is sent
    });
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    const Refusal &refusal = table.outcome()->result.error();
    EXPECT_EQ(refusal.id, RefusalId::wrongParameterData);
    EXPECT_EQ(refusal.arguments,
              (std::vector<RefusalArgument>{Parameter::revolutions, Parameter::coding, Word{0x8200'0000}}));
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::error);
}

struct ErrorRow
{
    const char *name;
    Word in;
    RefusalCode id;
};

class FrabaErrors : public testing::TestWithParam<ErrorRow>
{};

// FRABA manual 10.3
TEST_P(FrabaErrors, AreNamedAndStopTheJob)
{
    DriverTable table(u"fraba-ocd-ib");
    table.tell(Parameter::multiTurnAndStepsMinusOne, 2);
    ASSERT_TRUE(table.begin(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}));
    table.play({{0x0000'0000, pos},
                {0x0200'00FF, pos},
                {0x0200'00FF, GetParam().in},
                {0x0000'0000, GetParam().in},
                {0x0000'0000, GetParam().in}});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error().id, GetParam().id);
    EXPECT_EQ(std::get<Word>(table.outcome()->result.error().arguments.back()), GetParam().in);
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::error);
}

INSTANTIATE_TEST_SUITE_P(
    Manual103, FrabaErrors,
    testing::Values(ErrorRow{"wrongData", 0x8200'0000, RefusalId::wrongParameterData},
                    ErrorRow{"unknownNumber", 0x8400'0000, RefusalId::unknownParameterNumber},
                    ErrorRow{"parametersLost", 0x8600'0000, RefusalId::parametersLost},
                    ErrorRow{"aboveLargest", 0x9800'0004, WordRefusalId::camPositionAboveRange},
                    ErrorRow{"manufacturer", 0x9800'0007, RefusalId::manufacturerError}),
    [](const auto &row) { return row.param.name; });

} // namespace
} // namespace codewheel
