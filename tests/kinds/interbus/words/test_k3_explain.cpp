// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/interbus/words/explain_table.h"
#include "tests/support/word_source.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel::k3 {
namespace {

using enum MeaningId;

constexpr ExplainContext toFraba{WordDirection::out, Dialect::fraba, Mode::position, {}, {}};
constexpr ExplainContext fromFraba{
    WordDirection::in, Dialect::fraba, Mode::position, PositionCoding::binary, {}};

ExplainContext withMode(ExplainContext context, std::optional<Mode> mode)
{
    context.mode = mode;
    return context;
}

struct Row
{
    Word word;
    Meaning meaning;
};

void expectEach(std::span<const Row> rows, const ExplainContext &context)
{
    for (const Row &row : rows)
        EXPECT_EQ(explain(row.word, context), row.meaning) << std::hex << row.word;
}

// The rows of the appendix are in test_fraba_appendix.cpp; these are the cases in between.
TEST(K3Explain, ProfileFunctionsAreThoseOfEveryMake)
{
    constexpr Row rows[] = {
        {0x0000'0000, {normalRunning}},
        {0x0000'3039, {normalRunningData, {12345}}},
        {0x8000'0000, {run}},
        {0x8200'00FF, {runIgnoresRest, {0x0200'00FF}}},
        {0x4000'0000, {initialisePreset}},
        {0x0200'1000, {parameterRequest, {1, 4096}}},
        {0x03FF'FFFF, {parameterRequest, {1, 33'554'431}}},
        {0x0400'0003, {parameterRequest, {2, 3}}},
        {0x0600'0004, {parameterRequest, {3, 4}}},
        {0x0800'0064, {parameterRequest, {4, 100}}},
        {0x0A00'0064, {parameterRequest, {5, 100}}},
        {0x0E00'0000, {resetToDefault}},
        {0x0E00'0001, {parameterRequest, {7, 1}}},
        {0x1E00'1000, {parameterRequest, {15, 4096}}},
    };
    for (const Dialect dialect : {Dialect::generic, Dialect::fraba, Dialect::baumer})
        expectEach(rows, {WordDirection::out, dialect, Mode::position, {}, {}});
}

TEST(K3Explain, ManufacturerSpecificFunctionsAreTheSameInPositionAndVelocityMode)
{
    constexpr Row rows[] = {
        {0x6000'0000, {frabaPreset}},
        {0x2040'0001, {velocityOn}},
        {0x2040'0000, {velocityOff}},
        {0x2021'0009, {readOutRequest, {9}}},
        {0x2021'000D, {opcRegisterRequest, {0}}},
        {0x2021'007D, {opcRegisterRequest, {7}}},
        {0x2021'010D, {readOutRequest, {0x10D}}},
        {0x2121'0001, {undefinedOut, {0x2121'0001}}}, // D24 belongs to the word
    };
    expectEach(rows, toFraba);
    expectEach(rows, withMode(toFraba, Mode::velocity));
}

TEST(K3Explain, ReturnCodesWithOtherBitsAndNumbers)
{
    constexpr Row rows[] = {
        {0x8000'0001, {noValidPosition}},
        {0x9800'0017, {manufacturerError, {0x17}}},
        {0x9800'0100, {deviceError, {12, 0x100}}},
        {0x01FF'FFFF, {position, {33'554'431}}},
        {0x3E00'0001, {position, {1}}}, // D29..D25 mean nothing in operation
        {0xC000'0005, {processing, {5}}},
        {0xC300'0000, {confirmed, {1, 0x100'0000}}},
        {0xE200'0001, {confirmed, {1, 1}}},
        {0xA000'2000, {selfTestOrReadOut, {8192}}},
        {0xA200'0000, {undefinedIn, {0xA200'0000}}},
        {0x4000'0000, {unknownState, {0x4000'0000}}},
    };
    expectEach(rows, fromFraba);
}

TEST(K3Explain, CamFunctionsAtTheEndsOfTheirRanges)
{
    constexpr Row out[] = {
        {0x2080'0008, {camMode, {8}}},
        {0x6F00'0000, {camStop, {7, 0x100'0000}}},
        {0x5000'0000, {undefinedOut, {0x5000'0000}}}, // cam 8
        {0x2020'0018, {undefinedOut, {0x2020'0018}}},
    };
    expectEach(out, withMode(toFraba, Mode::cam));
    constexpr Row back[] = {
        {0x0001'2345, {cams, {0x45, 0x123}}}, {0xD000'0000, {undefinedIn, {0xD000'0000}}}, // cam 8
    };
    expectEach(back, withMode(fromFraba, Mode::cam));
}

TEST(K3Explain, CamWordsAreUndefinedOutsideCamMode)
{
    for (const Word word :
         {0x4600'0015u, 0x6600'0213u, 0x2040'0008u, 0x2010'0003u, 0x2000'0000u, 0x4000'0001u})
        EXPECT_EQ(explain(word, toFraba), (Meaning{undefinedOut, {word}})) << std::hex << word;
}

// k3.md, "Words whose meaning depends on the mode"
TEST(K3Explain, UnknownModeGivesBothMeaningsPositionFirst)
{
    const ExplainContext unknown = withMode(toFraba, {});
    EXPECT_EQ(explain(0x4000'0000, unknown), meanings({{initialisePreset}, {camStart, {0, 0}}}));
    EXPECT_EQ(explain(0x6000'0000, unknown), meanings({{frabaPreset}, {camStop, {0, 0}}}));
    EXPECT_EQ(explain(0x2040'0000, unknown), meanings({{velocityOff}, {camConfiguration, {0}}}));
    EXPECT_EQ(explain(0x2040'0001, unknown), meanings({{velocityOn}, {camConfiguration, {1}}}));
    EXPECT_EQ(explain(0x4600'0015, unknown), (Meaning{camStart, {3, 0x15}}));

    ExplainContext from = withMode(fromFraba, {});
    EXPECT_EQ(explain(0x01FF'FFFF, from),
              meanings({{position, {33'554'431}}, {velocity, {-1}}, {cams, {0xFF, 0x1FFFF}}}));
    EXPECT_EQ(explain(0xC200'00FF, from),
              meanings({{confirmed, {1, 255}}, {camConfirmation, {0x4200'00FF}}}));
    EXPECT_EQ(explain(0x8400'0000, from), meanings({{deviceError, {2, 0}}, {wrongCamCommand, {0}}}));
    from.counterpart = 0x0200'00FF; // an acknowledged parameter word: not cam mode
    EXPECT_EQ(explain(0xC200'00FF, from), (Meaning{confirmed, {1, 255}}));
    from.counterpart = 0x4600'0015; // likewise for cam words
    EXPECT_EQ(explain(0xC600'0015, from), (Meaning{camConfirmation, {0x4600'0015}}));
}

TEST(K3Explain, AReadOutMeansWhatWasAskedFor)
{
    const auto beside = [](Word out) {
        ExplainContext context = fromFraba;
        context.counterpart = out;
        return explain(0xA000'2000, context);
    };
    EXPECT_EQ(beside(0x2021'0001), (Meaning{readOutValue, {1, 8192}}));
    EXPECT_EQ(beside(0x2021'003D), (Meaning{opcRegisterValue, {3, 8192}}));
    EXPECT_EQ(beside(0x2020'0027), (Meaning{camStopValue, {7, 8192}}));
    EXPECT_EQ(beside(0x2020'0050), (Meaning{selfTestOrReadOut, {8192}}));
    EXPECT_EQ(beside(0x0000'0000), (Meaning{selfTestOrReadOut, {8192}}));
}

TEST(K3Explain, PositionsFollowTheCoding)
{
    ExplainContext context{WordDirection::in, Dialect::baumer, {}, {}, {}};
    EXPECT_EQ(explain(0x01FF'FFFF, context), (Meaning{rawPosition, {0x01FF'FFFF}}));
    context.coding = PositionCoding::signedBinary;
    EXPECT_EQ(explain(0x01FF'FFFF, context), (Meaning{signedPosition, {-1}}));
    EXPECT_EQ(explain(0x0100'0000, context), (Meaning{signedPosition, {-16'777'216}}));
    EXPECT_EQ(explain(0x0000'01F3, context), (Meaning{signedPosition, {499}}));
    context.coding = PositionCoding::gray;
    EXPECT_EQ(explain(0x0000'0003, context), (Meaning{grayPosition, {2, 3}}));
    EXPECT_EQ(explain(0x0100'0000, context), (Meaning{grayPosition, {33'554'431, 0x0100'0000}}));
}

// Baumer manual 2.2 and 2.3: D29 is manufacturer-specific, and the manufacturer says nothing about it.
TEST(K3Explain, BaumerIgnoresD29)
{
    const ExplainContext out{WordDirection::out, Dialect::baumer, {}, {}, {}};
    EXPECT_EQ(explain(0x2200'00FF, out), (Meaning{manufacturerBitIgnored, {0x0200'00FF}}));
    EXPECT_EQ(explain(0x6000'0000, out), (Meaning{manufacturerBitIgnored, {0x4000'0000}}));
    EXPECT_EQ(explain(0x4200'0000, out), (Meaning{undefinedOut, {0x4200'0000}}));
    ExplainContext in{WordDirection::in, Dialect::baumer, {}, PositionCoding::binary, {}};
    EXPECT_EQ(explain(0xA200'0000, in), (Meaning{deviceError, {1, 0}}));
    EXPECT_EQ(explain(0x9C00'0000, in), (Meaning{deviceError, {14, 0}}));
    EXPECT_EQ(explain(0xA000'0000, in), (Meaning{noValidPosition}));
    EXPECT_EQ(explain(0x2000'0005, in), (Meaning{position, {5}}));
    in.counterpart = 0x2200'00FF;
    EXPECT_EQ(explain(0xC400'0001, in), (Meaning{oldConfirmation, {2, 1, 1}}));
}

TEST(K3Explain, GenericLeavesD29ToTheManufacturer)
{
    const ExplainContext out{WordDirection::out, Dialect::generic, Mode::position, {}, {}};
    for (const Word word : {0x2021'0001u, 0x2200'00FFu, 0x2040'0002u})
        EXPECT_EQ(explain(word, out), (Meaning{manufacturerSpecificOut, {word}}));
    const ExplainContext in{WordDirection::in, Dialect::generic, Mode::position, {}, {}};
    EXPECT_EQ(explain(0xA000'2000, in), (Meaning{manufacturerSpecificIn, {0xA000'2000}}));
    EXPECT_EQ(explain(0x9800'0004, in), (Meaning{deviceError, {12, 4}}));
    EXPECT_EQ(explain(0x0000'0005, in), (Meaning{rawPosition, {5}}));
}

// An encoder of unknown make may be a FRABA, in any mode.
TEST(K3Explain, GenericOutWordsMayBeThoseOfFrabaInAnyMode)
{
    const auto both = [](Word word, std::initializer_list<Meaning> ofFraba) {
        Explanation all(Meaning{manufacturerSpecificOut, {word}});
        for (const Meaning &meaning : ofFraba)
            all.add(meaning);
        return all;
    };
    ExplainContext out{WordDirection::out, Dialect::generic, {}, {}, {}};
    EXPECT_EQ(explain(0x4000'0000, out), meanings({{initialisePreset}, {camStart, {0, 0}}}));
    EXPECT_EQ(explain(0x4600'0015, out), (Meaning{camStart, {3, 0x15}}));
    EXPECT_EQ(explain(0x6000'0000, out), both(0x6000'0000, {{frabaPreset}, {camStop, {0, 0}}}));
    EXPECT_EQ(explain(0x6600'0213, out), both(0x6600'0213, {{camStop, {3, 0x213}}}));
    EXPECT_EQ(explain(0x2040'0000, out), both(0x2040'0000, {{velocityOff}, {camConfiguration, {0}}}));
    EXPECT_EQ(explain(0x2040'0001, out), both(0x2040'0001, {{velocityOn}, {camConfiguration, {1}}}));
    EXPECT_EQ(explain(0x2080'0001, out), both(0x2080'0001, {{camMode, {1}}}));
    EXPECT_EQ(explain(0x0200'00FF, out), (Meaning{parameterRequest, {1, 255}}));

    out.mode = Mode::position;
    EXPECT_EQ(explain(0x4000'0000, out), (Meaning{initialisePreset}));
    EXPECT_EQ(explain(0x6000'0000, out), both(0x6000'0000, {{frabaPreset}}));
    out.mode = Mode::cam; // so it is a FRABA
    EXPECT_EQ(explain(0x4000'0000, out), (Meaning{camStart, {0, 0}}));
    EXPECT_EQ(explain(0x6000'0000, out), (Meaning{camStop, {0, 0}}));
    EXPECT_EQ(explain(0x0200'00FF, out), (Meaning{parameterRequestInCamMode, {1, 255}}));
}

TEST(K3Explain, GenericInWordsMayBeThoseOfFrabaInAnyMode)
{
    ExplainContext in{WordDirection::in, Dialect::generic, {}, {}, {}};
    EXPECT_EQ(explain(0x01FF'FFFF, in),
              meanings({{rawPosition, {0x01FF'FFFF}}, {velocity, {-1}}, {cams, {0xFF, 0x1FFFF}}}));
    EXPECT_EQ(explain(0x8400'0000, in), meanings({{deviceError, {2, 0}}, {wrongCamCommand, {0}}}));
    in.counterpart = 0x0200'00FF;
    EXPECT_EQ(explain(0xC200'00FF, in), (Meaning{confirmed, {1, 255}}));
    in.counterpart = 0x4600'0015;
    EXPECT_EQ(explain(0xC600'0015, in), (Meaning{camConfirmation, {0x4600'0015}}));
    in = {WordDirection::in, Dialect::generic, Mode::cam, {}, {}};
    EXPECT_EQ(explain(0x0001'2345, in), (Meaning{cams, {0x45, 0x123}}));
}

// Every dialect, direction and mode, with any coding and many words of the other direction, known or unknown.
template <typename Check>
void forAllContexts(int randomWords, Check check)
{
    WordSource source;
    std::vector<Word> words = cornerWords();
    for (int i = 0; i < randomWords; ++i)
        words.push_back(source.next());
    const auto anyCoding = [&source]() -> std::optional<PositionCoding> {
        const int coding = source.below(4);
        return coding == 3 ? std::nullopt : std::optional(static_cast<PositionCoding>(coding));
    };
    for (const WordDirection direction : {WordDirection::in, WordDirection::out})
        for (const Dialect dialect : {Dialect::generic, Dialect::fraba, Dialect::baumer})
            for (const std::optional<Mode> mode : {std::optional<Mode>(), std::optional(Mode::position),
                                                   std::optional(Mode::velocity), std::optional(Mode::cam)})
                for (const Word word : words) {
                    const bool toldCounterpart = source.below(3) != 0;
                    const Word counterpart = source.next();
                    check(word, ExplainContext{direction, dialect, mode, anyCoding(),
                                               toldCounterpart ? std::optional(counterpart) : std::nullopt});
                }
}

TEST(K3Explain, EveryWordHasAMeaningOfItsDirectionInEveryContext)
{
    forAllContexts(50'000, [](Word word, const ExplainContext &context) {
        const Explanation explanation = explain(word, context);
        ASSERT_GE(explanation.size(), 1u) << std::hex << word;
        ASSERT_EQ(explanation, explain(word, context)) << std::hex << word;
        for (const Meaning &meaning : explanation)
            ASSERT_EQ(meaning.id <= undefinedOut, context.direction == WordDirection::out)
                << std::hex << word;
    });
}

// IN lacks D30 of the cam word it acknowledges; beside a different OUT word it cannot be recovered.
bool mayAcknowledgeTwoCamWords(const Explanation &explanation)
{
    return explanation.size() == 2 && std::ranges::all_of(explanation, [](const Meaning &meaning) {
               return meaning.id == camConfirmation;
           });
}

TEST(K3Explain, WhoIsToldEverythingGetsOneMeaning)
{
    forAllContexts(50'000, [](Word word, const ExplainContext &context) {
        const bool modeTold = context.mode || context.dialect == Dialect::baumer;
        const bool needsMake = context.dialect == Dialect::generic && (word & manufacturerBit) != 0;
        if (!modeTold || needsMake || !context.coding || !context.counterpart)
            return;
        const Explanation explanation = explain(word, context);
        ASSERT_TRUE(explanation.isUnique() || mayAcknowledgeTwoCamWords(explanation)) << std::hex << word;
    });
}

TEST(K3Explain, KnowingTheModeOnlyTakesMeaningsAway)
{
    const auto saysNothing = [](const Meaning &meaning) {
        return meaning.id == undefinedOut || meaning.id == undefinedIn ||
               meaning.id == parameterRequestInCamMode;
    };
    forAllContexts(20'000, [&](Word word, ExplainContext context) {
        context.counterpart.reset(); // it may also tell the mode
        const Explanation all = explain(word, withMode(context, {}));
        for (const Meaning &meaning : explain(word, context)) {
            ASSERT_TRUE(saysNothing(meaning) || std::ranges::find(all, meaning) != all.end())
                << std::hex << word;
        }
    });
}

} // namespace
} // namespace codewheel::k3
