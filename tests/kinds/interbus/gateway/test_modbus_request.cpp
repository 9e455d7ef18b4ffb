// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes are those of the examples in Modbus Application Protocol V1.1b3, 6.
#include "kinds/interbus/gateway/rtu_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace codewheel {
namespace {

using testing::ElementsAre;

const ModbusBytes readHolding{0x03, 0x00, 0x6B, 0x00, 0x03};
const ModbusBytes readInput{0x04, 0x00, 0x08, 0x00, 0x01};
const ModbusBytes writeOne{0x06, 0x00, 0x01, 0x00, 0x03};
const ModbusBytes writeTwo{0x10, 0x00, 0x01, 0x00, 0x02, 0x04, 0x00, 0x0A, 0x01, 0x02};
const ModbusBytes maskWrite{0x16, 0x00, 0x04, 0x00, 0xF2, 0x00, 0x25};
const ModbusBytes readAndWrite{0x17, 0x00, 0x03, 0x00, 0x06, 0x00, 0x0E, 0x00,
                               0x03, 0x06, 0x00, 0xFF, 0x00, 0xFF, 0x00, 0xFF};
const std::vector<ModbusBytes> examples{readHolding, readInput, writeOne, writeTwo, maskWrite, readAndWrite};

ModbusException exceptionOf(const ModbusBytes &pdu)
{
    const auto parsed = ModbusRequest::parse(pdu);
    EXPECT_FALSE(parsed);
    return parsed ? ModbusException{} : parsed.error();
}

TEST(ModbusRequest, ReadsAreUnderstood)
{
    const auto holding = ModbusRequest::parse(readHolding);
    ASSERT_TRUE(holding);
    EXPECT_EQ(holding->area, RegisterArea::holding);
    EXPECT_EQ(holding->readFirst, 0x6B);
    EXPECT_EQ(holding->readCount, 3);
    EXPECT_TRUE(holding->changes.empty());
    EXPECT_EQ(ModbusRequest::parse(readInput)->area, RegisterArea::input);
}

TEST(ModbusRequest, WritesAreUnderstood)
{
    const auto one = ModbusRequest::parse(writeOne);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->writeFirst, 1);
    ASSERT_EQ(one->changes.size(), 1U);
    EXPECT_EQ(one->changes[0].value, 3);
    EXPECT_EQ(one->changes[0].mask, 0xFFFF);
    EXPECT_EQ(one->readCount, 0);

    const auto two = ModbusRequest::parse(writeTwo);
    ASSERT_TRUE(two);
    ASSERT_EQ(two->changes.size(), 2U);
    EXPECT_EQ(two->changes[1].value, 0x0102);

    const auto both = ModbusRequest::parse(readAndWrite);
    ASSERT_TRUE(both);
    EXPECT_EQ(both->readFirst, 3);
    EXPECT_EQ(both->readCount, 6);
    EXPECT_EQ(both->writeFirst, 14);
    EXPECT_EQ(both->changes.size(), 3U);
}

// The example of the standard: 12h becomes 17h.
TEST(ModbusRequest, AMaskWriteChangesTheBitsOutsideItsFirstMask)
{
    const auto masked = ModbusRequest::parse(maskWrite);
    ASSERT_TRUE(masked);
    const ModbusRequest::Change change = masked->changes.at(0);
    EXPECT_EQ((0x12 & ~change.mask) | (change.value & change.mask), 0x17);
}

TEST(ModbusRequest, OtherFunctionsAreRefused)
{
    for (int function = 0; function < 256; ++function)
        if (!std::ranges::count(examples, function, [](const ModbusBytes &one) { return int{one[0]}; })) {
            EXPECT_EQ(exceptionOf({static_cast<std::uint8_t>(function), 0, 0, 0, 1}),
                      ModbusException::illegalFunction)
                << function;
        }
    EXPECT_EQ(exceptionOf({}), ModbusException::illegalFunction);
}

TEST(ModbusRequest, BadCountsAreRefused)
{
    EXPECT_EQ(exceptionOf({0x03, 0, 0, 0, 0}), ModbusException::illegalValue);
    EXPECT_EQ(exceptionOf({0x04, 0, 0, 0, 126}), ModbusException::illegalValue);
    EXPECT_TRUE(ModbusRequest::parse(ModbusBytes{0x04, 0, 0, 0, 125}));
    EXPECT_EQ(exceptionOf({0x10, 0, 0, 0, 0, 0}), ModbusException::illegalValue);
    EXPECT_EQ(exceptionOf({0x10, 0, 0, 0, 2, 2, 1, 2}), ModbusException::illegalValue) << "two, but one came";
    ModbusBytes tooMany{0x10, 0, 0, 0, 124, 248};
    tooMany.resize(6 + 248);
    EXPECT_EQ(exceptionOf(tooMany), ModbusException::illegalValue);
    ModbusBytes tooManyWithRead{0x17, 0, 0, 0, 1, 0, 0, 0, 122, 244};
    tooManyWithRead.resize(10 + 244);
    EXPECT_EQ(exceptionOf(tooManyWithRead), ModbusException::illegalValue);
}

TEST(ModbusRequest, AWrongLengthIsRefused)
{
    for (const ModbusBytes &example : examples) {
        ModbusBytes longer = example;
        longer.push_back(0);
        EXPECT_EQ(exceptionOf(longer), ModbusException::illegalValue) << int{example[0]};
        for (std::size_t length = 1; length < example.size(); ++length)
            EXPECT_EQ(exceptionOf({example.begin(), example.begin() + static_cast<std::ptrdiff_t>(length)}),
                      ModbusException::illegalValue)
                << int{example[0]} << ' ' << length;
    }
}

TEST(ModbusRequest, AnswersAreThoseOfTheStandard)
{
    EXPECT_THAT(modbusAnswer(readHolding, {0x022B, 0x0000, 0x0064}),
                ElementsAre(0x03, 0x06, 0x02, 0x2B, 0x00, 0x00, 0x00, 0x64));
    EXPECT_EQ(modbusAnswer(writeOne, std::vector<Register>()), writeOne);
    EXPECT_THAT(modbusAnswer(writeTwo, std::vector<Register>()), ElementsAre(0x10, 0x00, 0x01, 0x00, 0x02));
    EXPECT_EQ(modbusAnswer(maskWrite, std::vector<Register>()), maskWrite);
    EXPECT_THAT(modbusAnswer(readInput, ModbusException::deviceFailure), ElementsAre(0x84, 0x04));
}

ModbusBytes framed(int unit, const ModbusBytes &pdu)
{
    return rtuFrame(unit, pdu);
}

// "123456789" is the usual check of CRC-16/MODBUS.
TEST(RtuFrame, HasTheChecksumOfTheStandard)
{
    const ModbusBytes check{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    EXPECT_EQ(modbusCrc(check), 0x4B37);
    EXPECT_EQ(modbusCrc(framed(1, readHolding)), 0);
}

TEST(RtuRequests, ARequestEndsWithItsLastByteHoweverItComes)
{
    for (const ModbusBytes &example : examples) {
        const ModbusBytes frame = framed(17, example);
        RtuRequests requests;
        for (std::size_t i = 0; i + 1 < frame.size(); ++i) {
            requests.take(std::span(frame).subspan(i, 1));
            EXPECT_FALSE(requests.next());
        }
        requests.take(std::span(frame).last(1));
        const auto request = requests.next();
        ASSERT_TRUE(request) << int{example[0]};
        EXPECT_EQ(request->unit, 17);
        EXPECT_EQ(request->pdu, example);
        EXPECT_FALSE(requests.isWithin());
    }
}

TEST(RtuRequests, OneOfAnUnknownFunctionEndsWithSilence)
{
    const ModbusBytes identify{0x2B, 0x0E, 0x01, 0x00};
    RtuRequests requests;
    requests.take(framed(1, identify));
    EXPECT_FALSE(requests.next());
    const auto request = requests.silence();
    ASSERT_TRUE(request);
    EXPECT_EQ(request->pdu, identify);
    EXPECT_FALSE(requests.silence());
}

// On a line with other units, whose answers look like the beginning of a request.
TEST(RtuRequests, WhatIsBetweenRequestsIsPassedOver)
{
    ModbusBytes damaged = framed(1, readHolding);
    damaged[3] ^= 0x10;
    const ModbusBytes half = framed(1, writeTwo);
    RtuRequests requests;
    for (const ModbusBytes &other :
         {ModbusBytes{}, damaged, framed(2, {0x03, 0x02, 0x12, 0x34}), ModbusBytes{0xFF, 0x10},
          ModbusBytes(half.begin(), half.begin() + 5), ModbusBytes(700, 0x55), framed(2, {0x90, 0x02})}) {
        requests.take(other);
        EXPECT_FALSE(requests.next());
        requests.take(framed(1, readInput));
        const auto request = requests.next();
        ASSERT_TRUE(request);
        EXPECT_EQ(request->pdu, readInput);
    }
}

TEST(RtuRequests, SeveralComeOneAfterTheOther)
{
    RtuRequests requests;
    requests.take(framed(1, readInput));
    requests.take(framed(2, writeTwo));
    EXPECT_EQ(requests.next()->pdu, readInput);
    EXPECT_EQ(requests.next()->pdu, writeTwo);
    EXPECT_FALSE(requests.next());
}

// What comes is not remembered without end: half a request is forgotten once it can be none any more.
TEST(RtuRequests, AnyBytesAreBounded)
{
    std::mt19937 random(7);
    RtuRequests requests;
    int found = 0;
    for (int i = 0; i < 100'000; ++i) {
        const ModbusBytes byte{static_cast<std::uint8_t>(random())};
        requests.take(byte);
        found += requests.next() ? 1 : 0;
    }
    EXPECT_LE(found, 2) << "by chance";
    requests.take(framed(1, readInput));
    EXPECT_TRUE(requests.next());
}

} // namespace
} // namespace codewheel
