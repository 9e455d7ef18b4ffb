// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/ruler_scale.h"

#include <algorithm>
#include <cmath>

namespace codewheel {
namespace {

constexpr double fewestShown = 10; // positions; there is nothing more to see closer up

// The smallest of 1, 2, 5, 10, 20, ... that is not below `least`.
std::int64_t roundNumber(double least)
{
    std::int64_t power = 1;
    while (true) {
        for (const std::int64_t digit : {1, 2, 5})
            if (static_cast<double>(digit * power) >= least)
                return digit * power;
        power *= 10;
    }
}

} // namespace

void RulerScale::setLargest(std::int64_t largest)
{
    if (largest == m_largest)
        return;
    m_largest = std::max<std::int64_t>(largest, 1);
    showAll();
}

void RulerScale::setColumns(int left, int width)
{
    m_left = left;
    m_width = std::max(width, 1);
}

double RulerScale::x(double position) const
{
    return m_left + (position - m_first) / m_shown * m_width;
}

double RulerScale::positionAt(double x) const
{
    return m_first + (x - m_left) / m_width * m_shown;
}

double RulerScale::positionsPerColumn() const
{
    return m_shown / m_width;
}

std::int64_t RulerScale::tickStep(double apart) const
{
    return roundNumber(apart * positionsPerColumn());
}

std::vector<std::int64_t> RulerScale::ticks(std::int64_t step) const
{
    std::vector<std::int64_t> all;
    const double last = std::min(m_first + m_shown, static_cast<double>(m_largest));
    for (auto tick = static_cast<std::int64_t>(std::ceil(m_first / static_cast<double>(step))) * step;
         static_cast<double>(tick) <= last; tick += step)
        all.push_back(tick);
    return all;
}

std::int64_t RulerScale::dragStep() const
{
    return positionsPerColumn() <= 1 ? 1 : roundNumber(positionsPerColumn());
}

void RulerScale::zoom(double factor, double aroundX)
{
    const double fixed = positionAt(aroundX);
    m_shown = std::max(m_shown / factor, std::min(fewestShown, static_cast<double>(total())));
    m_first = fixed - (aroundX - m_left) / m_width * m_shown;
    keepInRange();
}

void RulerScale::showAll()
{
    m_shown = static_cast<double>(total());
    m_first = 0;
}

void RulerScale::scrollTo(double first)
{
    m_first = first;
    keepInRange();
}

void RulerScale::reveal(std::int64_t position)
{
    const auto wanted = static_cast<double>(position);
    if (wanted < m_first)
        scrollTo(wanted);
    else if (wanted + 1 > m_first + m_shown)
        scrollTo(wanted + 1 - m_shown);
}

void RulerScale::keepInRange()
{
    m_shown = std::min(m_shown, static_cast<double>(total()));
    m_first = std::clamp(m_first, 0.0, static_cast<double>(total()) - m_shown);
}

} // namespace codewheel
