// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace codewheel {

// The resolution of an encoder: 8192 steps per turn and 4096 turns for "13 + 12 bit", the largest there is.
struct PhysicalResolution
{
    int stepsPerTurn = 8192; // 1..8192
    int turns = 4096;        // 1..4096

    constexpr std::int64_t range() const { return std::int64_t{stepsPerTurn} * turns; }
};

// The shaft of a simulated encoder: stands still or turns, and wraps at the physical range. The position is
// kept in a unit in which every speed is a whole number per cycle, so that it never drifts.
class TurningShaft
{
public:
    static constexpr double fastest = 12'000; // rpm, mechanical limit

    explicit TurningShaft(PhysicalResolution resolution, std::int64_t raw = 0);

    PhysicalResolution resolution() const { return m_resolution; }
    std::int64_t raw() const { return m_position / unitsPerStep; } // steps, 0..range - 1
    double speed() const;                                          // rpm, clockwise positive

    void turnTo(std::int64_t raw); // any number; wraps
    void turnBy(std::int64_t steps);
    void setSpeed(double rpm); // rounded to 0.001 rpm, limited to +-fastest; not a number: ignored

    // Moves on by one bus cycle of 1 ms.
    void advance()
    {
        m_position += m_unitsPerCycle;
        if (m_position >= m_unitsOfRange)
            m_position -= m_unitsOfRange;
        else if (m_position < 0)
            m_position += m_unitsOfRange;
    }

    void advance(std::chrono::milliseconds time)
    {
        for (auto left = time.count(); left > 0; --left)
            advance();
    }

    // Whether the code changes faster than this (1000 times steps per cycle).
    bool isFasterThan(std::int64_t stepsPerCycle) const
    {
        const std::int64_t limit = stepsPerCycle * unitsPerStep;
        return m_unitsPerCycle > limit || m_unitsPerCycle < -limit;
    }

private:
    // 60 000 cycles a minute, and speeds in thousandths of a revolution per minute.
    static constexpr std::int64_t unitsPerStep = std::int64_t{60'000} * 1'000;

    PhysicalResolution m_resolution;
    std::int64_t m_unitsOfRange;
    std::int64_t m_position = 0; // units, 0..m_unitsOfRange - 1
    std::int64_t m_unitsPerCycle = 0;
};

} // namespace codewheel
