// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/k3_word.h"

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
        const bool row = last.out != out || (changed & watchedBits(in)) != 0 || !last.seen;
        last = {out, in, true};
        return row;
    }

private:
    struct Last
    {
        Word out = 0;
        Word in = 0;
        bool seen = false;
    };

    // A position may change without a row, anything else may not.
    static constexpr Word watchedBits(Word in) { return k3::isOperation(in) ? k3::controlMask : ~Word{0}; }

    std::vector<Last> m_last;
};

} // namespace codewheel
