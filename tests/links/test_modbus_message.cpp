// SPDX-License-Identifier: GPL-3.0-or-later
// Requests and answers as the examples of the standard have them (Modbus Application Protocol V1.1b3, 6).
#include "kinds/interbus/links/modbus_message.h"

#include <gtest/gtest.h>

namespace codewheel::modbus_message {
namespace {

using Registers = std::vector<Register>;

RegisterError::Kind kindOf(const Pdu &request, const Pdu &answer)
{
    Registers registers(3, 0xBEEF);
    const auto taken = take(request, answer, registers);
    EXPECT_EQ(registers, Registers(3, 0xBEEF));
    return taken ? RegisterError::Kind::noAnswer : taken.error().kind;
}

TEST(ModbusMessage, ReadsAreThoseOfTheStandard)
{
    const Pdu request = read(3, 107, 3);
    EXPECT_EQ(request, (Pdu{0x03, 0x00, 0x6B, 0x00, 0x03}));
    const Pdu answer{0x03, 0x06, 0x02, 0x2B, 0x00, 0x00, 0x00, 0x64};
    EXPECT_EQ(answerLength(request), answer.size());
    Registers registers(3);
    EXPECT_TRUE(take(request, answer, registers));
    EXPECT_EQ(registers, (Registers{555, 0, 100}));
}

TEST(ModbusMessage, WritesAreThoseOfTheStandard)
{
    const Pdu request = write(1, Registers{0x000A, 0x0102});
    EXPECT_EQ(request, (Pdu{0x10, 0x00, 0x01, 0x00, 0x02, 0x04, 0x00, 0x0A, 0x01, 0x02}));
    const Pdu answer{0x10, 0x00, 0x01, 0x00, 0x02};
    EXPECT_EQ(answerLength(request), answer.size());
    EXPECT_TRUE(take(request, answer, {}));
}

TEST(ModbusMessage, WritesWithAReadAreThoseOfTheStandard)
{
    const Pdu request = writeAndRead(14, Registers{0xFF, 0xFF, 0xFF}, 3, 6);
    EXPECT_EQ(request, (Pdu{0x17, 0x00, 0x03, 0x00, 0x06, 0x00, 0x0E, 0x00, 0x03, 0x06, 0x00, 0xFF, 0x00,
                            0xFF, 0x00, 0xFF}));
    const Pdu answer{0x17, 0x0C, 0x00, 0xFE, 0x0A, 0xCD, 0x00, 0x01, 0x00, 0x03, 0x00, 0x0D, 0x00, 0xFF};
    EXPECT_EQ(answerLength(request), answer.size());
    Registers registers(6);
    EXPECT_TRUE(take(request, answer, registers));
    EXPECT_EQ(registers, (Registers{0xFE, 0x0ACD, 1, 3, 13, 255}));
}

TEST(ModbusMessage, NothingIsTakenFromAWrongAnswer)
{
    const Pdu request = read(3, 107, 3);
    using Kind = RegisterError::Kind;
    EXPECT_EQ(kindOf(request, {}), Kind::wrongAnswer);
    EXPECT_EQ(kindOf(request, {0x03}), Kind::wrongAnswer);
    EXPECT_EQ(kindOf(request, {0x04, 0x06, 1, 2, 3, 4, 5, 6}), Kind::wrongAnswer);
    EXPECT_EQ(kindOf(request, {0x03, 0x04, 1, 2, 3, 4}), Kind::wrongAnswer);
    EXPECT_EQ(kindOf(request, {0x03, 0x05, 1, 2, 3, 4, 5, 6}), Kind::wrongAnswer);
    EXPECT_EQ(kindOf(request, {0x83}), Kind::wrongAnswer);
    EXPECT_EQ(kindOf(request, {0x83, 2, 0}), Kind::wrongAnswer);
    EXPECT_EQ(kindOf(request, {0x84, 2}), Kind::wrongAnswer);
    EXPECT_EQ(kindOf(request, {0x83, 2}), Kind::exception);
}

} // namespace
} // namespace codewheel::modbus_message
