// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "jobs/plc_words.h"
#include "jobs/protocol.h"
#include "jobs/values_to_write.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;

class PlannedWords : public testing::Test
{
protected:
    std::vector<Word> wordsOf(QStringView device, const std::vector<Known> &known, const Job &job,
                              Word out = 0x0000'0000)
    {
        const auto steps = plannedSteps(*catalog.find(device), job, {.known = known, .out = out});
        EXPECT_TRUE(steps);
        std::vector<Word> words;
        for (const Step &step : steps.value_or(std::vector<Step>{}))
            words.push_back(step.out);
        return words;
    }
    static Known readFlag(std::int64_t value)
    {
        return {Parameter::multiTurnAndStepsMinusOne, value, Evidence::read, {}};
    }

    const Catalog catalog = Catalog::builtIn();
    const WriteParameters manualsExample{.values = {{Parameter::steps, 255},
                                                    {Parameter::revolutions, 1},
                                                    {Parameter::direction, 3},
                                                    {Parameter::preset, 0}},
                                         .previous = {}};
};

TEST_F(PlannedWords, OfTheManualsExampleEndWithTheReadBack)
{
    EXPECT_THAT(wordsOf(u"fraba-ocd-ib", {readFlag(2)}, manualsExample),
                ElementsAre(0x0200'00FF, 0x0400'0001, 0x0600'0003, 0x0800'0000, 0x8000'0000, 0x0000'0000,
                            0x2021'0001, 0x0000'0000, 0x2021'0002, 0x0000'0000, 0x2021'0003, 0x0000'0000,
                            0x2021'0004, 0x0000'0000));
}

TEST_F(PlannedWords, AskForTheFlagFirstWhereItIsNotKnown)
{
    const WriteParameters steps{.values = {{Parameter::steps, 255}}, .previous = {}};
    EXPECT_THAT(wordsOf(u"fraba-ocd-ib", {}, steps),
                ElementsAre(0x2021'000A, 0x0000'0000, 0x0200'00FF, 0x8000'0000, 0x0000'0000, 0x2021'0001,
                            0x0000'0000));
    EXPECT_THAT(wordsOf(u"fraba-ocd-ib", {readFlag(3)}, steps),
                ElementsAre(0x0200'00FE, 0x8000'0000, 0x0000'0000, 0x2021'0001, 0x0000'0000));
}

TEST_F(PlannedWords, BeginWithZeroWhereSomethingElseStandsInOut)
{
    const WriteParameters revolutions{.values = {{Parameter::revolutions, 1}}, .previous = {}};
    EXPECT_THAT(wordsOf(u"baumer-gxp6w", {}, revolutions, 0x8000'0000),
                ElementsAre(0x0000'0000, 0x0400'0001, 0x8000'0000, 0x0000'0000));
    EXPECT_THAT(wordsOf(u"baumer-gxp6w", {}, SendWords{{0x4000'0000}}, 0x8000'0000),
                ElementsAre(0x4000'0000));
}

TEST_F(PlannedWords, OfAnEncoderWithoutReadOutEndWithThePreset)
{
    EXPECT_THAT(
        wordsOf(u"baumer-gxp6w", {},
                WriteParameters{.values = {{Parameter::revolutions, 1}, {Parameter::measuringRange, 5}},
                                .previous = {},
                                .initialisePreset = true}),
        ElementsAre(0x0400'0001, 0x1E00'0005, 0x8000'0000, 0x0000'0000, 0x4000'0000, 0x0000'0000));
}

// LA-66 manual 4
TEST_F(PlannedWords, OfARodAreThreeForEachService)
{
    const WriteParameters length{.values = {{Parameter::measuringLength, 50'000}}, .previous = {}};
    EXPECT_THAT(wordsOf(u"tr-la66", {}, length),
                ElementsAre(0x4200'C350, 0xC200'C350, 0x4200'C350, 0x0200'0000, 0x8200'0000, 0x0200'0000,
                            0x0000'0000));
    EXPECT_THAT(wordsOf(u"tr-la66", {}, SetPreset{.value = 1'000}),
                ElementsAre(0x4600'03E8, 0xC600'03E8, 0x4600'03E8, 0x0000'0000));
    EXPECT_THAT(wordsOf(u"tr-la66", {}, SendWords{{0xC100'0001, 0x0000'0000}}),
                ElementsAre(0x4100'0001, 0xC100'0001, 0x4100'0001, 0x0000'0000));
    const auto steps = plannedSteps(*catalog.find(u"tr-la66"), length);
    const auto writing = std::ranges::find_if(*steps, writesValue);
    ASSERT_NE(writing, steps->end());
    EXPECT_EQ(writing->out, 0xC200'C350u);
    EXPECT_EQ(std::ranges::count_if(*steps, writesValue), 1);
}

// A PLC has no use for the read-out behind it.
TEST_F(PlannedWords, ForAPlcAreTheHandshakeAlone)
{
    const auto words = [this](QStringView device, const ParameterValues &values,
                              const std::vector<Known> &known = {}) {
        return plcWords(*catalog.find(device), values, known).value_or(std::vector<Word>{});
    };
    EXPECT_THAT(words(u"fraba-ocd-ib", {{Parameter::revolutions, 1}, {Parameter::steps, 255}}),
                ElementsAre(0x0200'00FF, 0x0400'0001, 0x8000'0000, 0x0000'0000));
    EXPECT_THAT(words(u"fraba-ocd-ib", {{Parameter::steps, 255}}, {readFlag(3)}),
                ElementsAre(0x0200'00FE, 0x8000'0000, 0x0000'0000));
    EXPECT_THAT(words(u"tr-la66", {{Parameter::measuringLength, 50'000}}),
                ElementsAre(0x4200'C350, 0xC200'C350, 0x4200'C350, 0x0000'0000));
    EXPECT_TRUE(words(u"kuebler-esc-rs422", {{Parameter::preset, 5}}).empty());
    EXPECT_FALSE(plcWords(*catalog.find(u"baumer-gxp6w"), {{Parameter::revolutions, 20'000}}));
}

TEST_F(PlannedWords, AreRefusedWhereTheInputIsBad)
{
    const auto steps =
        plannedSteps(*catalog.find(u"baumer-gxp6w"),
                     WriteParameters{.values = {{Parameter::revolutions, 20'000}}, .previous = {}});
    ASSERT_FALSE(steps);
    EXPECT_EQ(steps.error().id, RefusalId::valueOutOfRange);
}

} // namespace
} // namespace codewheel
