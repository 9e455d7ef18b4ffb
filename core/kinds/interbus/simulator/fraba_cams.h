// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"

#include <array>
#include <cstdint>
#include <optional>

namespace codewheel {

// Manufacturer error "cam start or stop above the largest position" (FRABA manual 10.4).
inline constexpr Word camAboveLargestPosition = 0x9800'0004;

// The cam unit of a FRABA encoder (FRABA manual 5.4.4, 10.5, 10.6): 8 programs of 8 cams, of which the
// entered one is in use. It is saved on leaving it and lost if power goes off before that.
class FrabaCams
{
public:
    static constexpr unsigned programs = 8;  // 1..8
    static constexpr Word cams = 8;          // 0..7
    static constexpr Word largestShift = 25; // shift_iw: cams only

    bool isEntered() const { return m_entered != 0; }
    unsigned program() const { return m_entered; } // 0: none is entered

    void enter(unsigned program);
    // Saves the program if it was changed: then true, one EEPROM write.
    bool leave();
    void powerUp(); // the entered program as last saved
    void clear();   // all off, start = stop = 0, shift 0; none is entered

    // 4xxxxxxx, 6xxxxxxx, 2040xxxx, 201000xx, for an encoder with this many positions. Empty: accepted;
    // otherwise the error word, and the old value is kept.
    std::optional<Word> take(Word out, std::int64_t totalRange);
    // 2020xxxx; empty: not defined.
    std::optional<Word> readOut(Word what) const;

    // IN: the active cams in D7..D0, the part of the position left by shift_iw above them.
    Word word(std::int64_t position) const;

private:
    struct Cam
    {
        Word start = 0;
        Word stop = 0;
    };
    struct Program
    {
        std::array<Cam, cams> cam{};
        Word active = 0; // bit n: cam n; bits 8..15 do nothing
        Word shift = 0;
    };

    static bool isOn(const Cam &cam, Word position);

    std::array<Program, programs> m_stored{};
    Program m_current;
    unsigned m_entered = 0;
    bool m_changed = false;
};

} // namespace codewheel
