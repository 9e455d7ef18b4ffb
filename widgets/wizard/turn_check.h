// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace codewheel {

// Which way an encoder counts while its shaft is turned: takes the positions as they come and determines
// whether most moves went up or down. A wrap is recognised if the total range is known, and outvoted if not.
class TurnCheck
{
public:
    enum class Verdict : std::uint8_t { doesNotMove, countsUp, countsDown, goesBothWays };

    // In steps.
    void begin(std::int64_t totalRange);
    void take(std::int64_t position);

    Verdict verdict() const;
    std::int64_t moved() const { return m_moved; } // steps since begin(), up is positive

private:
    std::int64_t m_total = 0;
    std::optional<std::int64_t> m_last;
    std::int64_t m_moved = 0;
    int m_ups = 0;
    int m_downs = 0;
};

} // namespace codewheel
