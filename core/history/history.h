// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/sample.h"

#include <functional>
#include <optional>
#include <vector>

namespace codewheel {

// What happened to a value over time: what it was in every cycle, and where there was none. Where it stood,
// there may be only its first and its newest sample. Knows what the samples of any span have been without
// going through them, so that a curve shows a spike of one cycle at every zoom. In memory (MemoryHistory), or
// in a file (RecordedHistory).
class History
{
public:
    // Nothing is known from `from` until the next sample, at `to`.
    struct Gap
    {
        Instant from{};
        Instant to{};

        friend bool operator==(const Gap &, const Gap &) = default;
    };
    // What a curve draws of one stretch of time, such as a column of pixels.
    struct Column
    {
        Summary summary;
        std::int64_t first = 0;
        std::int64_t last = 0;
        bool hasGap = false; // inside it, or between it and the sample before

        friend bool operator==(const Column &, const Column &) = default;
    };
    using Columns = std::vector<std::optional<Column>>;
    struct Statistics
    {
        Extent extent;
        double mean = 0;      // over time: each value counts for as long as it stood
        double deviation = 0; // the standard deviation, over time as well
        Instant known{};      // for how long there was a value

        friend bool operator==(const Statistics &, const Statistics &) = default;
    };
    using With = std::function<void(const Sample &sample)>;

    virtual ~History() = default;

    virtual std::optional<TimeSpan> span() const = 0; // from the first sample to just behind the last one
    virtual std::optional<Sample> newest() const = 0; // nothing: none as yet, or it is in a gap
    // The newest sample up to then: its value stood then. Nothing: it is not in the span, or is in a gap.
    virtual std::optional<Sample> at(Instant at) const = 0;
    // The first sample behind that one, under the same conditions.
    virtual std::optional<Sample> after(Instant at) const = 0;
    virtual std::size_t count(const TimeSpan &span) const = 0; // of the samples in it, or a few more
    virtual std::optional<Extent> extent(const TimeSpan &span) const = 0; // of the samples in it
    // One for each of `count` equal parts of the span, oldest first; nothing where it has no sample.
    virtual Columns columns(const TimeSpan &span, std::size_t count) const = 0;
    // Nothing also where they take longer: then Archive::statisticsReady() says when to ask again.
    virtual std::optional<Statistics> statistics(const TimeSpan &span) const = 0;
    // Those that reach into the span, oldest first; the last one ends at Instant::max() while no sample has
    // followed.
    virtual std::vector<Gap> gaps(const TimeSpan &span) const = 0;
    // Calls `with` with each sample of the span, oldest first.
    virtual void forEach(const TimeSpan &span, const With &with) const = 0;
};

} // namespace codewheel
