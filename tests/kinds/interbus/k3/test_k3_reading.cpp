// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_reading.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using k3::Dialect;

struct StateRow
{
    Word in;
    Dialect dialect;
    EncoderState state;
    std::optional<unsigned> error;
};

// "The K3 words" of the profile, and the differences between makes
TEST(K3Reading, StateIsThatOfTheStatusBits)
{
    const StateRow rows[] = {
        {0x0000'3039, Dialect::fraba, EncoderState::operation, {}},
        {0x2000'3039, Dialect::baumer, EncoderState::operation, {}},
        {0x1E00'3039, Dialect::baumer, EncoderState::operation, {}},
        {0xC200'00FF, Dialect::fraba, EncoderState::parameterization, {}},
        {0xE200'00FF, Dialect::baumer, EncoderState::parameterization, {}},
        {0x8200'0000, Dialect::fraba, EncoderState::error, 1},
        {0x9E00'0000, Dialect::baumer, EncoderState::error, 15},
        {0x8000'0000, Dialect::fraba, EncoderState::error, 0},
        {0xA000'2000, Dialect::fraba, EncoderState::readOut, {}},
        {0xA400'000B, Dialect::fraba, EncoderState::readOut, {}},
        {0xA200'0000, Dialect::baumer, EncoderState::error, 1},
        {0x4000'0000, Dialect::fraba, EncoderState::unknown, {}},
    };
    for (const StateRow &row : rows) {
        const Reading reading =
            decodeReading(row.in, Instant{7}, {.dialect = row.dialect, .mode = {}, .coding = {}});
        EXPECT_EQ(reading.state, row.state) << std::hex << row.in;
        EXPECT_EQ(reading.errorNumber, row.error) << std::hex << row.in;
        EXPECT_EQ(reading.position, std::nullopt) << "the coding is not known";
    }
}

struct PositionRow
{
    Word in;
    PositionCoding coding;
    std::int64_t position;
};

// Baumer manual 5, "Coding": 200 steps, 5 turns: 0..999, -500..499
TEST(K3Reading, PositionIsReadByItsCoding)
{
    const PositionRow rows[] = {
        {0x0000'03E7, PositionCoding::binary, 999},
        {0x01FF'FE0C, PositionCoding::signedBinary, -500},
        {0x0000'01F3, PositionCoding::signedBinary, 499},
        {0x0100'0000, PositionCoding::signedBinary, -16'777'216},
        {0x0000'0214, PositionCoding::gray, 999},
        {0x0100'0000, PositionCoding::gray, 33'554'431},
    };
    for (const PositionRow &row : rows)
        EXPECT_EQ(decodeReading(row.in, {}, {.dialect = Dialect::baumer, .mode = {}, .coding = row.coding})
                      .position,
                  row.position)
            << std::hex << row.in;
}

TEST(K3Reading, OutsidePositionModeThereIsNoPosition)
{
    K3View view{
        .dialect = Dialect::fraba, .mayHaveModes = true, .mode = {}, .coding = PositionCoding::binary};
    EXPECT_EQ(decodeReading(100, {}, view).position, std::nullopt);
    view.mode = Mode::velocity;
    EXPECT_EQ(decodeReading(100, {}, view).position, std::nullopt);
    view.mode = Mode::position;
    EXPECT_EQ(decodeReading(100, {}, view).position, 100);
}

} // namespace
} // namespace codewheel
