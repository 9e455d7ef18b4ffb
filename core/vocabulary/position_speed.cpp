// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/position_speed.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant smoothedOver = 500ms;
constexpr std::size_t enoughChanges = 8;
constexpr Instant shortestSpan = 100ms;
constexpr Instant longestSpan = 20s;
constexpr Instant changeDistance = 10ms; // between those that are kept
constexpr Instant notable = 50ms;        // after that long without a change the shaft has slowed down

// What a shaft can do, in turns.
constexpr double topSpeed = 200;     // a second
constexpr double hardest = 300;      // acceleration, per second squared
constexpr double updateTime = 0.003; // seconds; an encoder may update its position in bursts
constexpr double briefly = 0.01;     // seconds

double seconds(Instant duration)
{
    return std::chrono::duration<double>(duration).count();
}

} // namespace

void PositionSpeed::setScale(const std::optional<Scale> &scale)
{
    if (m_scale == scale)
        return;
    m_scale = scale;
    restart();
}

void PositionSpeed::restart()
{
    m_last.reset();
    m_changes.clear();
    m_mayMissTurns = false;
}

void PositionSpeed::begin(const Sample &first)
{
    m_last = m_newer = m_older = first;
    m_changedAt = first.at;
    m_changes.clear();
}

void PositionSpeed::observe(Instant at, std::int64_t position)
{
    if (!m_scale || m_scale->stepsPerTurn <= 0 || (m_last && at == m_last->at))
        return;
    if (!m_last || at < m_last->at || at - m_last->at > longestGap) {
        begin({at, position});
        return;
    }
    const auto way = wayTo(position, seconds(at - m_last->at));
    if (!way) {
        begin({at, position});
        return;
    }
    m_last = {at, position, m_last->way + *way};
    if (at - m_newer.at >= changeDistance)
        m_older = std::exchange(m_newer, *m_last);
    if (*way != 0)
        noteChange();
}

std::optional<double> PositionSpeed::after(const std::optional<std::int64_t> &position, Instant at)
{
    if (position)
        observe(at, *position);
    else
        restart();
    return stepsPerSecond();
}

// Steps per second over the last milliseconds, from which the next position is predicted.
std::optional<double> PositionSpeed::recently() const
{
    if (m_last->at == m_older.at)
        return std::nullopt;
    return static_cast<double>(m_last->way - m_older.way) / seconds(m_last->at - m_older.at);
}

// From the last position; empty where the shaft cannot have turned that far, or may have got there in more
// than one way.
std::optional<std::int64_t> PositionSpeed::wayTo(std::int64_t position, double after)
{
    const double turn = m_scale->stepsPerTurn;
    const auto speed = recently();
    const double expected = speed.value_or(0) * after;
    const double change = speed ? hardest * turn * std::pow(std::max(after, briefly), 2) +
                                      std::abs(*speed) * std::max(after, updateTime)
                                : topSpeed * turn * after;
    const double tolerance = change + 2;
    std::int64_t way = position - m_last->position;
    if (m_scale->total) {
        const auto total = static_cast<double>(*m_scale->total);
        way += std::llround((expected - static_cast<double>(way)) / total) * *m_scale->total;
        const double otherWay = total - std::abs(static_cast<double>(way) - expected);
        m_mayMissTurns = otherWay <= tolerance;
        if (m_mayMissTurns)
            return std::nullopt;
    }
    return std::abs(static_cast<double>(way) - expected) > tolerance ? std::nullopt : std::optional(way);
}

void PositionSpeed::noteChange()
{
    const Instant quiet = m_last->at - std::exchange(m_changedAt, m_last->at);
    const bool hasStood =
        m_changes.size() > 2 && quiet > smoothedOver && quiet > m_changes.back().at - m_changes.front().at;
    if (hasStood)
        m_changes.clear();
    if (!m_changes.empty() && m_last->at - m_changes.back().at < changeDistance)
        return;
    m_changes.push_back(*m_last);
    forgetOldChanges();
    m_slope = slope();
}

void PositionSpeed::forgetOldChanges()
{
    const Instant now = m_changes.back().at;
    const auto isDispensable = [&] {
        return m_changes.size() > enoughChanges && now - m_changes[1].at >= smoothedOver;
    };
    while (m_changes.size() > 2 && (isDispensable() || now - m_changes.front().at > longestSpan))
        m_changes.pop_front();
}

// Of the best-fitting straight line.
double PositionSpeed::slope() const
{
    const auto count = static_cast<double>(m_changes.size());
    double time = 0;
    double way = 0;
    double timeTime = 0;
    double timeWay = 0;
    for (const Sample &change : m_changes) {
        const double t = seconds(change.at - m_changes.front().at);
        const auto w = static_cast<double>(change.way - m_changes.front().way);
        time += t;
        way += w;
        timeTime += t * t;
        timeWay += t * w;
    }
    const double divisor = count * timeTime - time * time;
    return divisor > 0 ? (count * timeWay - time * way) / divisor : 0;
}

// While nothing changes, less than one step has been covered.
std::optional<double> PositionSpeed::stepsPerSecond() const
{
    if (!m_last)
        return std::nullopt;
    const Instant quiet = m_last->at - m_changedAt;
    if (m_changes.size() < 2 || m_changes.back().at - m_changes.front().at < shortestSpan)
        return quiet >= smoothedOver ? std::optional(0.0) : std::nullopt;
    if (quiet > longestSpan)
        return 0;
    if (quiet <= notable)
        return m_slope;
    const double most = 1 / seconds(quiet);
    return std::clamp(m_slope, -most, most);
}

} // namespace codewheel
