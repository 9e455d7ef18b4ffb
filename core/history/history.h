// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/sample_block.h"

#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace codewheel {

// What happened to a value over time: what it was in every cycle, and where there was none. While it stands,
// only its first and its newest sample are kept, so that a bus at rest costs nothing. Knows what the samples
// of any span have been without going through them, so that a curve shows a spike of one cycle at every zoom.
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
    struct Statistics
    {
        Extent extent;
        double mean = 0;      // over time: each value counts for as long as it stood
        double deviation = 0; // the standard deviation, over time as well
        Instant known{};      // for how long there was a value

        friend bool operator==(const Statistics &, const Statistics &) = default;
    };

    // False: it is older than the last one or lies in a gap, and is not kept.
    bool append(const Sample &sample);
    // From here on there is no value, until the next sample.
    void interrupt(Instant at);

    bool isEmpty() const { return m_blocks.empty(); }
    std::size_t size() const { return m_size; }
    std::optional<TimeSpan> span() const; // from the first sample to just behind the last one
    std::optional<Sample> newest() const; // nothing: none as yet, or it is in a gap
    // The newest sample up to then: its value stood then. Nothing: it is not in the span, or is in a gap.
    std::optional<Sample> at(Instant at) const;
    // The first sample behind that one, under the same conditions.
    std::optional<Sample> after(Instant at) const;
    std::size_t count(const TimeSpan &span) const;            // of the samples kept
    std::optional<Extent> extent(const TimeSpan &span) const; // of the samples kept in it
    // One for each of `count` equal parts of the span, oldest first; nothing where it has no sample.
    std::vector<std::optional<Column>> columns(const TimeSpan &span, std::size_t count) const;
    std::optional<Statistics> statistics(const TimeSpan &span) const;
    // Oldest first; the last one ends at Instant::max() while no sample has followed.
    const std::deque<Gap> &gaps() const { return m_gaps; }

    // Calls `with` with each sample of the span, oldest first.
    template <class With>
    void forEach(const TimeSpan &span, With with) const
    {
        for (std::size_t block = blockAt(span.from); block < m_blocks.size(); ++block) {
            const SampleBlock &samples = m_blocks[block];
            const std::size_t end = samples.indexAt(span.to);
            for (std::size_t index = samples.indexAt(span.from); index < end; ++index)
                with(samples[index]);
            if (end < samples.size())
                return;
        }
    }

    // So that older ones make room for new ones: some thousand samples go at once. The newest block stays.
    void forgetOldest();
    std::optional<Instant> oldestBlockEnd() const; // nothing: the newest block is the only one
    std::size_t bytes() const;                     // of memory

private:
    struct Position // of a sample
    {
        std::size_t block = 0;
        std::size_t index = 0;
    };

    std::size_t blockAt(Instant at) const; // the first one that ends no earlier
    Position find(Instant at) const;       // the first sample no older than that
    Sample sampleBefore(Position position) const;
    std::optional<Summary> summaryOf(Position begin, Position end) const;
    void addMoments(Moments &moments, const TimeSpan &span) const;
    bool hasGapAfter(Instant from, Instant until) const;
    bool isInGap() const { return !m_gaps.empty() && m_gaps.back().to == Instant::max(); }

    std::deque<SampleBlock> m_blocks;
    std::deque<Gap> m_gaps;
    std::size_t m_size = 0;
    std::size_t m_bytes = 0; // of all blocks but the newest
    bool m_stands = false;   // the last two samples are of one value, in one block, and no gap lies between
};

} // namespace codewheel
