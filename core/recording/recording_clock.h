// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recording_entry.h"

namespace codewheel {

// Which of the times the clock of the computer says have to be kept: the first one, and those after it was
// set (by hand, or by a time server) or the computer slept. The times of the recording go on evenly
// meanwhile.
class ClockWatch
{
public:
    static constexpr Instant least = std::chrono::milliseconds(500);  // that it was set by
    static constexpr Instant moment = std::chrono::milliseconds(100); // between two that are compared

    // What has to be kept since the last call; empty: nothing. A clock that was set says the same a moment
    // later; one that only seems to be was compared with the time of a bus that had not gone on yet, after a
    // pause of the program.
    std::optional<RecordedClock> news(const RecordedClock &clock);

private:
    bool isAhead(const RecordedClock &clock, Instant ahead) const;

    std::optional<Instant> m_ahead;          // of the recording
    std::optional<RecordedClock> m_doubtful; // the first that says something else
};

// What the clock of the computer said at a time of the recording. After it was set back there are two of
// these for one time of the day; after it was set forward, none for some.
class WallClock
{
public:
    explicit WallClock(std::vector<RecordedClock> clocks = {}); // in any order

    Instant wall(Instant at) const; // `at` itself where nothing is known
    // The times of the recording at which it was set, with what it said then.
    const std::vector<RecordedClock> &changes() const { return m_clocks; }

private:
    std::vector<RecordedClock> m_clocks; // oldest first
};

} // namespace codewheel
