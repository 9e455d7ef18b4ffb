// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/position_code.h"
#include "tests/kinds/interbus/words/explain_table.h"
#include "tests/support/word_source.h"

#include <bit>
#include <gtest/gtest.h>

// Built words are taken apart into their parts, and vice versa.
namespace codewheel::k3 {
namespace {

using enum MeaningId;

constexpr int randomWords = 1'000'000;

template <typename Check>
void forCornerAndRandomWords(Check check)
{
    for (const Word word : cornerWords())
        check(word);
    WordSource source;
    for (int i = 0; i < randomWords; ++i)
        check(source.next());
}

// The OUT word of a meaning: no bit may be lost.
Word outWord(const Meaning &meaning)
{
    const auto first = static_cast<Word>(meaning.number[0]);
    const auto second = static_cast<Word>(meaning.number[1]);
    switch (meaning.id) {
    case normalRunning:
        return 0;
    case run:
        return k3::run;
    case runIgnoresRest:
        return k3::run | first;
    case initialisePreset:
        return k3::initialisePreset;
    case frabaPreset:
        return k3::frabaPreset;
    case parameterRequest:
    case parameterRequestInCamMode:
        return parameterWord(first, second);
    case resetToDefault:
        return parameterWord(setToDefault, 0);
    case velocityOn:
        return k3::velocityOn;
    case velocityOff:
        return k3::velocityOff;
    case readOutRequest:
        return k3::readOut | first;
    case opcRegisterRequest:
        return readOutWord(first << 4 | 0xD);
    case camMode:
        return selectCamProgram(first);
    case positionMode:
        return selectCamProgram(0);
    case camConfiguration:
        return setActiveCams(first);
    case camStart:
        return k3::setCamStart(first, second);
    case camStop:
        return k3::setCamStop(first, second);
    case MeaningId::setCamShift:
        return k3::setCamShift(first);
    case camConfigurationRequest:
        return readOutCams(camConfigurationCode);
    case camStartRequest:
        return readOutCams(camStartCode + first);
    case camStopRequest:
        return readOutCams(camStopCode + first);
    case camShiftRequest:
        return readOutCams(camShiftCode);
    case manufacturerBitIgnored:
        return manufacturerBit | first;
    default: // normalRunningData, manufacturerSpecificOut, undefinedOut
        return first;
    }
}

TEST(Inverse, AnExplainedOutWordIsTheOneItsMeaningsAreBuiltTo)
{
    forCornerAndRandomWords([](Word word) {
        if (word == readOutCams(camShiftCodeOfTable)) // the other code for the same thing
            return;
        for (const Dialect dialect : {Dialect::generic, Dialect::fraba, Dialect::baumer})
            for (const Meaning &meaning : explain(word, {WordDirection::out, dialect, {}, {}, {}}))
                ASSERT_EQ(outWord(meaning), word) << std::hex << word;
        for (const Mode mode : {Mode::position, Mode::velocity, Mode::cam})
            for (const Dialect dialect : {Dialect::generic, Dialect::fraba})
                for (const Meaning &meaning : explain(word, {WordDirection::out, dialect, mode, {}, {}}))
                    ASSERT_EQ(outWord(meaning), word) << std::hex << word;
    });
}

TEST(Inverse, ParameterWords)
{
    forCornerAndRandomWords([](Word word) {
        const Word built = parameterWord(number(word), data(word));
        ASSERT_EQ(number(built), number(word));
        ASSERT_EQ(data(built), data(word));
        ASSERT_EQ(isParameterWord(built), number(word) != 0);
        if (isParameterWord(word)) {
            ASSERT_EQ(built, word);
        }
    });
}

TEST(Inverse, CamWordsOfIn)
{
    forCornerAndRandomWords([](Word word) {
        ASSERT_EQ(camWord(camsOn(word), camPositionPart(word)), data(word)) << std::hex << word;
    });
}

TEST(Inverse, EachGrayCodeIsOnePosition)
{
    for (Word position = 0; position <= dataMask; ++position) {
        const Word gray = grayFromBinary(position);
        ASSERT_LE(gray, dataMask);
        ASSERT_EQ(decodePosition(gray, PositionCoding::gray), position);
        ASSERT_EQ(std::popcount(gray ^ grayFromBinary(position + 1)), 1); // a step changes one bit
    }
}

TEST(Inverse, BinaryAndSignedPositions)
{
    forCornerAndRandomWords([](Word word) {
        ASSERT_EQ(decodePosition(word, PositionCoding::binary), data(word));
        const std::int64_t steps = decodePosition(word, PositionCoding::signedBinary);
        ASSERT_GE(steps, -16'777'216);
        ASSERT_LE(steps, 16'777'215);
        ASSERT_EQ(static_cast<Word>(steps) & dataMask, data(word));
    });
}

} // namespace
} // namespace codewheel::k3
