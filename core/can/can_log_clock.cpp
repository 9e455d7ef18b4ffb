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
    if (stamp.at >= relativeBelow) {
        ++m_large;
    } else {
        m_smaller += stamp.at < m_before ? 1 : 0;
        m_before = stamp.at;
    }
    if (m_looked >= looksToDecide)
        decide();
}

void CanLogClock::decide()
{
    if (m_isDecided)
        return;
    m_isDecided = true;
    if (m_large * 2 > m_looked)
        return;
    m_ofCandump = m_smaller * oneIn > m_looked - m_large ? CanLogTimes::differences : CanLogTimes::relative;
}

CanLogClock::Meaning CanLogClock::ascMeaning(const AscHeader &header) const
{
    const bool countsFromBefore =
        m_meant ? *m_meant == CanLogTimes::differences : header.times == AscHeader::Times::fromLineBefore;
    const bool isDated = m_meant != CanLogTimes::relative && header.date.has_value();
    Meaning meaning{.times = isDated ? CanLogTimes::absolute : CanLogTimes::relative, .isSince1970 = isDated};
    if (countsFromBefore)
        meaning.times = CanLogTimes::differences;
    if (isDated)
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

// What the times are said to be holds for all of them.
bool CanLogClock::isOfOtherKind(const CanLogStamp &stamp, const Meaning &meaning) const
{
    if (stamp.kind == CanLogStamp::Kind::candump && !m_meant &&
        (meaning.times == CanLogTimes::absolute) != (stamp.at >= relativeBelow))
        return true;
    return m_times && (meaning.isSince1970 != m_isSince1970 || (!m_isSince1970 && stamp.kind != m_kind));
}

CanLogTime CanLogClock::at(const CanLogStamp &stamp, const AscHeader &header, bool isOfFrame)
{
    if (stamp.kind == CanLogStamp::Kind::none)
        return {};
    const Meaning meaning = meaningOf(stamp, header);
    if (isOfOtherKind(stamp, meaning))
        return {.isOfOtherKind = true};
    Instant at = stamp.at;
    if (meaning.times == CanLogTimes::differences)
        at = added(at);
    else if (stamp.kind == CanLogStamp::Kind::asc && header.times == AscHeader::Times::ofDay)
        at = onDay(at);
    at += meaning.origin;
    if (!isOfFrame)
        return {};
    if (!m_times) {
        m_times = meaning.times;
        m_isSince1970 = meaning.isSince1970;
        m_kind = stamp.kind;
    }
    if (meaning.isSince1970)
        return {.at = at};
    m_first = m_first.value_or(at);
    return {.at = at - *m_first};
}

} // namespace codewheel
