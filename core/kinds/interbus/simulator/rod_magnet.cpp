// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/rod_magnet.h"

#include <algorithm>
#include <cmath>

namespace codewheel {
namespace {

constexpr double nanometresPerMillimetre = 1'000'000;
constexpr double nanometresPerCycle = 1'000; // at 1 mm/s
constexpr double shortestRange = 20;         // mm: twice as far as the fastest magnet travels in a cycle

} // namespace

RodMagnet::RodMagnet(double lengthMillimetres)
    : m_length(std::llround(std::max(lengthMillimetres, shortestRange) * nanometresPerMillimetre))
{}

double RodMagnet::millimetres() const
{
    return static_cast<double>(m_position) / nanometresPerMillimetre;
}

double RodMagnet::lengthInMillimetres() const
{
    return static_cast<double>(m_length) / nanometresPerMillimetre;
}

double RodMagnet::speed() const
{
    return static_cast<double>(m_perCycle) / nanometresPerCycle;
}

void RodMagnet::moveTo(double millimetres)
{
    if (!std::isnan(millimetres))
        m_position =
            std::llround(std::clamp(millimetres, 0.0, lengthInMillimetres()) * nanometresPerMillimetre);
}

void RodMagnet::setSpeed(double millimetresPerSec)
{
    if (!std::isnan(millimetresPerSec))
        m_perCycle = std::llround(std::clamp(millimetresPerSec, -fastest, fastest) * nanometresPerCycle);
}

} // namespace codewheel
