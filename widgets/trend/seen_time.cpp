// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/seen_time.h"

#include <cmath>

namespace codewheel {
namespace {

constexpr double mostBeside = 1.2; // of all there is

} // namespace

Instant SeenTime::times(double lengths) const
{
    return Instant(std::llround(lengths * static_cast<double>(length().count())));
}

void SeenTime::setAll(const TimeSpan &all, Instant newest)
{
    m_all = all;
    m_newest = newest;
    if (!m_follows)
        return;
    const Instant column = std::max((length() + Instant(m_columns / 2)) / m_columns, Instant(1));
    const Instant to = (newest / column + 1) * column;
    m_span = {to - column * m_columns, to};
}

void SeenTime::follow()
{
    m_follows = true;
    setAll(m_all, m_newest);
}

void SeenTime::show(const TimeSpan &span)
{
    const Instant longest = std::max(
        usual, Instant(std::llround(mostBeside * static_cast<double>((m_all.to - m_all.from).count()))));
    const Instant length = std::clamp(span.to - span.from, shortest, longest);
    const Instant from =
        std::clamp(span.from, m_all.from - length * 9 / 10, std::max(m_all.from, m_all.to - length / 10));
    m_follows = false;
    m_span = {from, from + length};
}

void SeenTime::showAll()
{
    const Instant margin = std::max((m_all.to - m_all.from) / 100, shortest);
    show({m_all.from - margin, m_all.to + margin});
}

void SeenTime::scroll(double lengths)
{
    show({m_span.from + times(lengths), m_span.to + times(lengths)});
}

void SeenTime::zoom(double factor, double at)
{
    const bool followed = m_follows;
    if (followed)
        at = 1;
    const Instant fixed = m_span.from + times(at);
    show({fixed - times(at * factor), fixed + times((1 - at) * factor)});
    if (followed)
        follow();
}

} // namespace codewheel
