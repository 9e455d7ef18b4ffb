// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/history.h"
#include "history/sample_block.h"

#include <deque>

namespace codewheel {

// What happened to a value since it is watched, every cycle. While it stands, only its first and its newest
// sample are kept, so that a bus at rest costs nothing.
class MemoryHistory final : public History
{
public:
    // False: it is older than the last one or lies in a gap, and is not kept.
    bool append(const Sample &sample);
    // From here on there is no value, until the next sample.
    void interrupt(Instant at);

    bool isEmpty() const { return m_blocks.empty(); }
    std::size_t size() const { return m_size; }
    std::optional<TimeSpan> span() const override;
    std::optional<Sample> newest() const override;
    std::optional<Sample> at(Instant at) const override;
    std::optional<Sample> after(Instant at) const override;
    std::size_t count(const TimeSpan &span) const override; // exactly
    std::optional<Extent> extent(const TimeSpan &span) const override;
    Columns columns(const TimeSpan &span, std::size_t count) const override;
    std::optional<Statistics> statistics(const TimeSpan &span) const override;
    const std::deque<Gap> &gaps() const { return m_gaps; } // all
    std::vector<Gap> gaps(const TimeSpan &span) const override;
    void forEach(const TimeSpan &span, const With &with) const override;

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
