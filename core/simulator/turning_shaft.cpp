// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/turning_shaft.h"

#include <algorithm>
#include <cmath>

namespace codewheel {

namespace {
constexpr double thousandths = 1'000;

// 0..range - 1, also for negative numbers
std::int64_t wrapped(std::int64_t value, std::int64_t range)
{
    const std::int64_t rest = value % range;
    return rest < 0 ? rest + range : rest;
}
} // namespace

TurningShaft::TurningShaft(PhysicalResolution resolution, std::int64_t raw)
    : m_resolution(resolution)
    , m_unitsOfRange(resolution.range() * unitsPerStep)
{
    turnTo(raw);
}

double TurningShaft::speed() const
{
    const std::int64_t revolutions = m_unitsPerCycle / m_resolution.stepsPerTurn; // in thousandths
    return static_cast<double>(revolutions) / thousandths;
}

void TurningShaft::turnTo(std::int64_t raw)
{
    m_position = wrapped(raw, m_resolution.range()) * unitsPerStep;
}

void TurningShaft::turnBy(std::int64_t steps)
{
    m_position = wrapped(m_position + wrapped(steps, m_resolution.range()) * unitsPerStep, m_unitsOfRange);
}

void TurningShaft::setSpeed(double rpm)
{
    if (std::isnan(rpm))
        return;
    const double limited = std::clamp(rpm, -fastest, fastest);
    m_unitsPerCycle = std::llround(limited * thousandths) * m_resolution.stepsPerTurn;
}

} // namespace codewheel
