// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/asc_log.h"
#include "can/can_log_line.h"

namespace codewheel {

// What the times of a log are.
enum class CanLogTimes : std::uint8_t {
    absolute,    // since 1970, or a date says since when
    relative,    // from a beginning that has no date
    differences, // each from the line before
};

// The time of a frame: since 1970 where that is known, else since the first frame.
struct CanLogTime
{
    std::optional<Instant> at{};
    bool isOfOtherKind = false; // than that of the first frame, and so it is left out
};

// Tells what the times of a log are, and works out that of each line. Seconds of candump do not say it: below
// 10^8 they are relative, and where more than one line in ten is smaller than the one before, they are
// differences; a few of the other size are neither. This is decided by the first 10 000 of them, so that a
// log of any length is read in one go.
class CanLogClock
{
public:
    explicit CanLogClock(std::optional<CanLogTimes> meant)
        : m_meant(meant)
    {}

    // All lines in turn, as long as it is not decided.
    void look(const CanLogStamp &stamp);
    bool isDecided() const { return m_isDecided; }
    void decide(); // by what was there

    // All lines in turn, once it is decided: also of those without a frame, as the next may count from them.
    CanLogTime at(const CanLogStamp &stamp, const AscHeader &header, bool isOfFrame);

    // Of the frames so far. Empty: none had a time.
    std::optional<CanLogTimes> times() const { return m_times; }
    bool isSince1970() const { return m_isSince1970; }

private:
    struct Meaning
    {
        CanLogTimes times = CanLogTimes::relative;
        Instant origin{};
        bool isSince1970 = false;
    };
    Meaning meaningOf(const CanLogStamp &stamp, const AscHeader &header) const;
    bool isOfOtherKind(const CanLogStamp &stamp, const Meaning &meaning) const;
    Meaning ascMeaning(const AscHeader &header) const;
    Instant added(Instant difference);
    Instant onDay(Instant timeOfDay);

    std::optional<CanLogTimes> m_meant;
    bool m_isDecided = true; // until there is a line that leaves it open
    bool m_hasLooked = false;
    CanLogTimes m_ofCandump = CanLogTimes::absolute;
    int m_looked = 0;
    int m_smaller = 0; // than the one before
    int m_large = 0;   // as those since 1970
    Instant m_before{};
    Instant m_sum{};
    Instant m_day{}; // days that have passed since the first time of day
    Instant m_ofDayBefore{};
    std::optional<Instant> m_first;
    std::optional<CanLogTimes> m_times;
    CanLogStamp::Kind m_kind = CanLogStamp::Kind::none; // of the first frame
    bool m_isSince1970 = false;
};

} // namespace codewheel
