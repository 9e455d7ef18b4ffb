// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/word.h"

#include <array>

namespace codewheel {

// Which bits of a word changed in the last half second, as seen from frame to frame. Used by WordView.
class ChangeMarks
{
public:
    static constexpr Instant duration = std::chrono::milliseconds(500);

    // edges: bits that changed in any cycle since the last call.
    void update(Word edges, Instant now)
    {
        for (std::size_t bit = 0; bit < m_until.size(); ++bit) {
            const Word mask = Word{1} << bit;
            Instant &until = m_until[bit];
            // If time has gone back, it is another bus, and the marks do not apply.
            const bool over = now >= until || now + duration < until;
            if ((edges & mask) != 0) {
                until = now + duration;
                m_bits |= mask;
            } else if (over) {
                m_bits &= ~mask;
            }
        }
    }

    Word bits() const { return m_bits; }

private:
    Word m_bits = 0;
    std::array<Instant, 32> m_until{};
};

} // namespace codewheel
