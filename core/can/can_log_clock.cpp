// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_log_clock.h"

#include "can/can_log_date.h"

#include <algorithm>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant relativeBelow = 100'000'000s;
constexpr int looksToDecide = 10'000;
constexpr int oneIn = 10;
constexpr Instant mostSum = std::chrono::hours(24 * 366 * 10'000); // sums of nonsense stay there

} // namespace

void CanLogClock::look(const CanLogStamp &stamp)
{
    if (stamp.kind != CanLogStamp::Kind::candump || m_meant || (m_hasLooked && m_isDecided))
        return;
    if (!m_hasLooked) {
        m_hasLooked = true;
        m_isDecided = stamp.at >= relativeBelow;
        m_before = stamp.at;
    }
    ++m_looked;
    m_smaller += stamp.at < m_before ? 1 : 0;
    m_before = stamp.at;
    if (m_looked >= looksToDecide)
        decide();
}

void CanLogClock::decide()
{
    if (m_isDecided)
        return;
    m_isDecided = true;
    m_ofCandump = m_smaller * oneIn > m_looked ? CanLogTimes::differences : CanLogTimes::relative;
}

CanLogClock::Meaning CanLogClock::ascMeaning(const AscHeader &header) const
{
    const bool countsFromBefore =
        m_meant ? *m_meant == CanLogTimes::differences : header.times == AscHeader::Times::fromLineBefore;
    const bool isDated =
        m_meant == CanLogTimes::absolute || (m_meant != CanLogTimes::relative && header.date);
    Meaning meaning{.times = isDated ? CanLogTimes::absolute : CanLogTimes::relative, .isSince1970 = isDated};
    if (countsFromBefore)
        meaning.times = CanLogTimes::differences;
    if (isDated && header.date)
        meaning.origin =
            header.times == AscHeader::Times::ofDay ? midnightBefore(*header.date) : *header.date;
    return meaning;
}

CanLogClock::Meaning CanLogClock::meaningOf(const CanLogStamp &stamp, const AscHeader &header) const
{
    if (stamp.kind == CanLogStamp::Kind::asc)
        return ascMeaning(header);
    CanLogTimes times = m_meant.value_or(m_ofCandump);
    if (stamp.kind == CanLogStamp::Kind::date && times == CanLogTimes::differences)
        times = CanLogTimes::absolute;
    return {.times = times, .isSince1970 = times == CanLogTimes::absolute};
}

Instant CanLogClock::added(Instant difference)
{
    m_sum = std::clamp(m_sum + difference, -mostSum, mostSum);
    return m_sum;
}

// Past midnight it begins anew.
Instant CanLogClock::onDay(Instant timeOfDay)
{
    constexpr Instant halfDay = 12h;
    if (timeOfDay < m_ofDayBefore - halfDay && m_day < mostSum)
        m_day += 2 * halfDay;
    m_ofDayBefore = timeOfDay;
    return m_day + timeOfDay;
}

std::optional<Instant> CanLogClock::at(const CanLogStamp &stamp, const AscHeader &header, bool isOfFrame)
{
    if (stamp.kind == CanLogStamp::Kind::none)
        return std::nullopt;
    const Meaning meaning = meaningOf(stamp, header);
    Instant at = stamp.at;
    if (meaning.times == CanLogTimes::differences)
        at = added(at);
    else if (stamp.kind == CanLogStamp::Kind::asc && header.times == AscHeader::Times::ofDay)
        at = onDay(at);
    at += meaning.origin;
    if (!isOfFrame)
        return std::nullopt;
    m_times = m_times.value_or(meaning.times);
    m_isSince1970 = meaning.isSince1970;
    if (meaning.isSince1970)
        return at;
    m_first = m_first.value_or(at);
    return at - *m_first;
}

} // namespace codewheel
