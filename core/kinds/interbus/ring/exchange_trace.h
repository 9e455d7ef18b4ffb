// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_word.h"

#include <algorithm>
#include <vector>

namespace codewheel {

// Decides which cycles of a device become rows of its trace (the rule is at Exchange): a turning shaft gives
// none. Used by the runner, once per device and cycle.
class ExchangeTrace
{
public:
    explicit ExchangeTrace(std::size_t devices)
        : m_last(devices)
    {}

    // The first cycle of a device is a row.
    bool isRow(std::size_t device, Word out, Word in)
    {
        Last &last = m_last[device];
        const Word changed = last.in ^ in;
        const bool isOther = last.out != out || (changed & watchedBits(in)) != 0 || !last.seen;
        const bool row = isJump(last, out, in) || isOther;
        last.out = out;
        last.in = in;
        last.seen = true;
        return row;
    }

private:
    static constexpr int cyclesOfPreset = 8; // behind the last cycle of the word (assumed)

    struct Last
    {
        Word out = 0;
        Word in = 0;
        bool seen = false;
        Word moved = 0;     // steps, in the last cycle without a jump
        int presetLeft = 0; // cycles in which a jump is what a preset has caused
    };

    // What 40000000h and 60000000h cause shows in the position alone (FRABA manual 5.4.1).
    static bool isJump(Last &last, Word out, Word in)
    {
        constexpr Word edge = 2; // steps that a shaft trembles by
        constexpr Word faster = 4;
        const bool isPreset = (out & k3::presetBit) != 0 && !k3::isParameterWord(out);
        last.presetLeft = isPreset ? cyclesOfPreset : std::max(last.presetLeft - 1, 0);
        if (!k3::isOperation(in) || !k3::isOperation(last.in))
            return false;
        const Word moved =
            std::max(k3::data(in), k3::data(last.in)) - std::min(k3::data(in), k3::data(last.in));
        if (last.presetLeft > 0 && moved > edge + faster * last.moved)
            return true;
        last.moved = moved;
        return false;
    }

    // A position may change without a row, anything else may not.
    static constexpr Word watchedBits(Word in) { return k3::isOperation(in) ? k3::controlMask : ~Word{0}; }

    std::vector<Last> m_last;
};

} // namespace codewheel
