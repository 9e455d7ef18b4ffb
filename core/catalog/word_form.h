// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"

namespace codewheel {

struct DeviceDescription;

// How a device divides its word into groups of bits, the lowest of which carry the data.
struct WordForm
{
    static constexpr Word nibbles = 0x1111'1111;

    int bits = 32;               // 16 or 32
    Word groupStarts = nibbles;  // the lowest bit of each group is set
    int dataBits = 32;           // D(n-1)..D0: what is shown as a number
    Word commandBits = ~Word{0}; // of OUT: if any is set, the device may act on it

    friend bool operator==(const WordForm &, const WordForm &) = default;
};

// bits: 16 or 32; device: null if not known, in which case every bit may have any meaning.
WordForm wordForm(int bits, const DeviceDescription *device);

// The data of a word of 32 bits of this device.
inline Word dataOf(const DeviceDescription &device, Word word)
{
    const int unused = 32 - wordForm(32, &device).dataBits;
    return word << unused >> unused;
}

} // namespace codewheel
