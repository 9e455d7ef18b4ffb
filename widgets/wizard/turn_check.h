// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace codewheel {

// Which way an encoder counts while its shaft is turned: takes the positions as they come and tells whether
// most moves went up or down. A wrap is seen through where the total range is known, and is outvoted where it
// is not.
class TurnCheck
{
public:
    enum class Verdict : std::uint8_t { doesNotMove, countsUp, countsDown, goesBothWays };

    // total range in steps; 25 bit where it is not known.
    void begin(std::optional<std::int64_t> totalRange);
    void take(std::int64_t position);

    Verdict verdict() const;
    std::int64_t moved() const { return m_moved; } // steps from the beginning, up is positive

private:
    std::int64_t m_total = 0;
    std::optional<std::int64_t> m_last;
    std::int64_t m_moved = 0;
    int m_ups = 0;
    int m_downs = 0;
};

} // namespace codewheel
