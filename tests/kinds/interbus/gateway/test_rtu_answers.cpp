// SPDX-License-Identifier: GPL-3.0-or-later
// Answers on a line with Modbus RTU, found among whatever else comes.
#include "kinds/interbus/gateway/rtu_answers.h"
#include "kinds/interbus/gateway/rtu_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

// "01 04 04 ..": unit 1, registers 1234h and 5678h; the checksums are those of an independent calculator.
const ModbusBytes readRequest{0x01, 0x04, 0x00, 0x00, 0x00, 0x02, 0x71, 0xCB};
const ModbusBytes readAnswer{0x01, 0x04, 0x04, 0x12, 0x34, 0x56, 0x78, 0x80, 0xB0};
const ModbusBytes pduOfIt{0x04, 0x04, 0x12, 0x34, 0x56, 0x78};

ModbusBytes together(std::initializer_list<ModbusBytes> parts)
{
    ModbusBytes all;
    for (const ModbusBytes &part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

ModbusBytes pduIn(RtuAnswers &answers)
{
    const auto frame = answers.next();
    return frame ? frame->pdu : ModbusBytes();
}

TEST(RtuAnswers, AreFoundWhateverPiecesTheyComeIn)
{
    for (std::size_t cut = 0; cut <= readAnswer.size(); ++cut) {
        RtuAnswers answers;
        answers.begin(readRequest);
        answers.take(std::span(readAnswer).first(cut));
        ASSERT_TRUE(cut == readAnswer.size() || !answers.next());
        EXPECT_EQ(answers.isWithin(), cut > 0);
        answers.take(std::span(readAnswer).subspan(cut));
        const auto frame = answers.next();
        ASSERT_TRUE(frame) << cut;
        EXPECT_EQ(frame->unit, 1);
        EXPECT_EQ(frame->pdu, pduOfIt);
        EXPECT_FALSE(answers.isWithin());
        EXPECT_EQ(answers.strayBytes(), 0U);
    }
}

TEST(RtuAnswers, BytesBeforeAndBehindAreDroppedAndCounted)
{
    RtuAnswers answers;
    for (const ModbusBytes &stray :
         {ModbusBytes{0x00}, ModbusBytes{0xFF}, ModbusBytes{0x01}, ModbusBytes{0x01, 0x04},
          ModbusBytes{0x01, 0x04, 0x04, 0x12}, ModbusBytes(40, 0x01)}) {
        const auto before = answers.strayBytes();
        answers.begin(readRequest);
        answers.take(together({stray, readAnswer, stray}));
        EXPECT_EQ(pduIn(answers), pduOfIt);
        EXPECT_FALSE(answers.next());
        answers.begin(readRequest); // what is behind it is none of the next answer
        EXPECT_EQ(answers.strayBytes() - before, 2 * stray.size());
        answers.take(readAnswer);
        EXPECT_EQ(pduIn(answers), pduOfIt);
    }
}

TEST(RtuAnswers, TheEchoOfTheRequestIsDroppedAndCounted)
{
    const ModbusBytes write = rtuFrame(1, {0x10, 0x00, 0x00, 0x00, 0x02, 0x04, 0x80, 0x00, 0x00, 0x00});
    const ModbusBytes written = rtuFrame(1, {0x10, 0x00, 0x00, 0x00, 0x02});
    // Reads from register 0300h on look like an answer of three bytes.
    const ModbusBytes readLikeAnswer = rtuFrame(1, {0x04, 0x03, 0x00, 0x00, 0x02});
    RtuAnswers answers;
    std::uint64_t requests = 0;
    for (const auto &[request, answer] :
         {std::pair{readRequest, readAnswer}, {write, written}, {readLikeAnswer, readAnswer}}) {
        answers.begin(request);
        answers.take(together({{0x00}, request, answer}));
        EXPECT_EQ(pduIn(answers), ModbusBytes(answer.begin() + 1, answer.end() - 2));
        EXPECT_FALSE(answers.next());
        EXPECT_EQ(answers.echoes(), ++requests);
    }
    EXPECT_EQ(answers.strayBytes(), requests);
}

// A write of 96 registers from 0 on, the first of them 21..h, begins like its own answer, checksum included.
TEST(RtuAnswers, WhatAnEchoBeginsWithIsNoAnswerWhereThereWereEchoes)
{
    const ModbusBytes written = rtuFrame(1, {0x10, 0x00, 0x00, 0x00, 0x60});
    ModbusBytes pdu{0x10, 0x00, 0x00, 0x00, 0x60, 0xC0, 0x21};
    pdu.resize(6 + 2 * 96);
    const ModbusBytes write = rtuFrame(1, pdu);
    ASSERT_TRUE(std::equal(written.begin(), written.end(), write.begin()));
    RtuAnswers answers;
    answers.begin(readRequest);
    answers.take(together({readRequest, readAnswer}));
    EXPECT_EQ(pduIn(answers), pduOfIt);
    answers.begin(write);
    answers.take(std::span(write).first(written.size()));
    EXPECT_FALSE(answers.next());
    answers.take(std::span(write).subspan(written.size()));
    EXPECT_FALSE(answers.next());
    answers.take(written);
    EXPECT_TRUE(answers.next());
}

TEST(RtuAnswers, OnesOfOtherUnitsAreToldAsTheirs)
{
    RtuAnswers answers;
    answers.begin(readRequest);
    answers.take(together({rtuFrame(7, pduOfIt), rtuFrame(1, {0x84, 0x0C})}));
    EXPECT_EQ(answers.next()->unit, 7);
    const auto exception = answers.next();
    ASSERT_TRUE(exception);
    EXPECT_THAT(exception->pdu, testing::ElementsAre(0x84, 0x0C)) << "whatever its code";
}

TEST(RtuAnswers, ADamagedOneIsNone)
{
    for (std::size_t byte = 0; byte < readAnswer.size(); ++byte) {
        RtuAnswers answers;
        answers.begin(readRequest);
        ModbusBytes damaged = readAnswer;
        damaged[byte] ^= 0x04;
        answers.take(damaged);
        EXPECT_FALSE(answers.next()) << byte;
    }
}

// What comes is not remembered without end.
TEST(RtuAnswers, AnswerBehindAnyNoiseIsFound)
{
    RtuAnswers answers;
    answers.begin(readRequest);
    for (int i = 0; i < 100; ++i) {
        answers.take(ModbusBytes(1'000, 0x55));
        EXPECT_FALSE(answers.next());
    }
    EXPECT_GE(answers.strayBytes(), 99'000U);
    answers.take(readAnswer);
    EXPECT_EQ(pduIn(answers), pduOfIt);
}

} // namespace
} // namespace codewheel
