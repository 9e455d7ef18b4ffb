// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/shaft_motion.h"

#include "encoder/circle.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant smoothedOver = 500ms;
constexpr Instant enough = 100ms;

} // namespace

void ShaftMotion::observe(Instant at, std::int64_t position, std::optional<std::int64_t> total)
{
    if (m_samples.empty()) {
        m_samples.push_back({at, position, 0});
        return;
    }
    const Sample &last = m_samples.back();
    if (at <= last.at)
        return;
    const std::int64_t way =
        total && *total > 0 ? shorterWay(last.shown, position, *total) : position - last.shown;
    m_samples.push_back({at, position, last.way + way});
    while (m_samples.size() > 2 && at - m_samples.front().at > smoothedOver)
        m_samples.pop_front();
}

std::optional<double> ShaftMotion::stepsPerSecond() const
{
    if (m_samples.size() < 2)
        return std::nullopt;
    const Sample &first = m_samples.front();
    const Sample &last = m_samples.back();
    if (last.at - first.at < enough)
        return std::nullopt;
    return static_cast<double>(last.way - first.way) /
           std::chrono::duration<double>(last.at - first.at).count();
}

} // namespace codewheel
