// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/simulated_device.h"
#include "simulator/turning_shaft.h"

#include <cstdio>
#include <gtest/gtest.h>
#include <initializer_list>
#include <string>

namespace codewheel {

inline constexpr PhysicalResolution thirteenPlusTwelve{8192, 4096};
inline constexpr Word pos = 0x0000'3039;    // 12345
inline constexpr Word pos255 = 0x0000'0180; // floor(12345 x 255 / 8192) = 384

// A row of a manual's table: the OUT and IN words, for this many cycles.
struct HandshakeRow
{
    Word out;
    Word in;
    int cycles = 1;
};

inline std::string hex8(Word word)
{
    char text[9];
    std::snprintf(text, sizeof text, "%08X", word);
    return text;
}

// Plays the rows cycle by cycle and checks every IN.
inline void play(SimulatedDevice &encoder, std::initializer_list<HandshakeRow> rows)
{
    int number = 0;
    for (const HandshakeRow &row : rows) {
        ++number;
        for (int cycle = 1; cycle <= row.cycles; ++cycle) {
            EXPECT_EQ(hex8(encoder.cycle(row.out)), hex8(row.in))
                << "row " << number << ", cycle " << cycle << ", OUT " << hex8(row.out);
        }
    }
}

// Holds each word for as many cycles as any answer of an encoder with normal timing takes. Returns the final
// IN.
inline Word send(SimulatedDevice &encoder, std::initializer_list<Word> words)
{
    Word in = 0;
    for (const Word out : words) {
        for (int cycle = 0; cycle < 6; ++cycle)
            in = encoder.cycle(out);
    }
    return in;
}

} // namespace codewheel
