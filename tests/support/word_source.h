// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace codewheel {

// Words from the manuals, at the ends of their ranges and just beyond: of the K3 profile, of FRABA and its
// cams, of the LA-66.
inline constexpr std::array manualWords{
    Word{0x0000'0000}, Word{0x8000'0000}, Word{0x4000'0000}, Word{0x6000'0000}, Word{0xC000'0000},
    Word{0xFFFF'FFFF}, Word{0x0E00'0000}, Word{0x0200'00FF}, Word{0x0400'0001}, Word{0x0600'0003},
    Word{0x0600'0004}, Word{0x0800'0064}, Word{0x0A00'0005}, Word{0x0C00'0005}, Word{0x1E00'0005},
    Word{0x2040'0000}, Word{0x2040'0001}, Word{0x2040'0008}, Word{0x2080'0000}, Word{0x2080'0001},
    Word{0x2080'0008}, Word{0x2080'000F}, Word{0x4600'0015}, Word{0x6600'0213}, Word{0x2010'0000},
    Word{0x2010'0019}, Word{0x2010'001A}, Word{0x2020'0000}, Word{0x2020'0013}, Word{0x2020'0023},
    Word{0x2020'0030}, Word{0x2020'0040}, Word{0x2021'0000}, Word{0x2021'0005}, Word{0x2021'0009},
    Word{0x2021'000B}, Word{0x2021'00FD}, Word{0x2021'010D}, Word{0x0000'FFFF}, Word{0x01FF'FFFF},
    Word{0x8200'00FF}, Word{0x9800'0004}, Word{0xA000'2000}, Word{0xA400'000B}, Word{0xC200'00FF},
    Word{0xE040'0008}, Word{0x4200'C350}, Word{0xC200'C350}, Word{0xC600'0000}, Word{0x8800'0000},
};

// Every first byte with a number of remainders that mean something to some device.
inline std::vector<Word> cornerWords()
{
    std::vector<Word> words(manualWords.begin(), manualWords.end());
    for (Word first = 0; first < 0x100; ++first)
        for (const Word rest : {0x00'0000u, 0x00'0001u, 0x00'0008u, 0x10'0019u, 0x20'0000u, 0x20'0013u,
                                0x20'0040u, 0x21'0001u, 0x21'007Du, 0x40'0001u, 0x80'0001u, 0xFF'FFFFu})
            words.push_back(first << 24 | rest);
    return words;
}

// Words for tests: from arbitrary ones to those that get through. Seeded: the same in each run.
class WordSource
{
public:
    Word next()
    {
        switch (below(4)) {
        case 0:
            return any();
        case 1:
            return (any() & 0x1E00'0000) | smallData(); // a parameter
        case 2:
            return (any() & 0xFE00'0000) | smallData();
        default:
            return manualWords[static_cast<std::size_t>(below(manualWords.size()))];
        }
    }
    Word any() { return static_cast<Word>(m_random()); }
    int below(std::size_t limit) { return static_cast<int>(m_random() % limit); }

private:
    Word smallData() { return any() & 0x01FF'FFFF >> below(25); }

    std::mt19937 m_random{71};
};

} // namespace codewheel
