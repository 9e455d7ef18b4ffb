// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace codewheel {

// The magnet on the rod of a simulated linear encoder: stands still, or travels and turns round at the ends.
// Counted in nanometres, in which every speed is a whole number per cycle, so that it never drifts.
class RodMagnet
{
public:
    static constexpr double fastest = 10'000; // mm/s, mechanical limit (assumed)

    explicit RodMagnet(double lengthMillimetres); // 20 mm at least

    std::int64_t nanometres() const { return m_position; } // from the head, 0..length
    std::int64_t lengthInNanometres() const { return m_length; }
    double millimetres() const;
    double lengthInMillimetres() const;
    double speed() const; // mm/s, positive: away from the head

    void moveTo(double millimetres);         // limited to the rod; not a number: ignored
    void setSpeed(double millimetresPerSec); // rounded to 0.001 mm/s, limited to +-fastest

    // Moves on by one bus cycle of 1 ms.
    void advance()
    {
        m_position += m_perCycle;
        if (m_position > m_length)
            turnRoundAt(m_length);
        else if (m_position < 0)
            turnRoundAt(0);
    }
    void advance(std::chrono::milliseconds time)
    {
        for (auto left = time.count(); left > 0; --left)
            advance();
    }

private:
    void turnRoundAt(std::int64_t end)
    {
        m_position = 2 * end - m_position;
        m_perCycle = -m_perCycle;
    }

    std::int64_t m_length;
    std::int64_t m_position = 0;
    std::int64_t m_perCycle = 0; // nm per ms = um/s
};

} // namespace codewheel
