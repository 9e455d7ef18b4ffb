// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/memory_history.h"

#include <iterator>

namespace codewheel {

bool MemoryHistory::append(const Sample &sample)
{
    const bool wasInGap = isInGap();
    if (!isEmpty() && sample.at < (wasInGap ? m_gaps.back().from : m_blocks.back().last()))
        return false;
    if (wasInGap)
        m_gaps.back().to = sample.at;
    if (isEmpty() || !m_blocks.back().takes(sample)) {
        m_bytes += isEmpty() ? 0 : m_blocks.back().bytes();
        m_blocks.emplace_back(sample);
        ++m_size;
        m_stands = false;
        return true;
    }
    SampleBlock &newest = m_blocks.back();
    const bool goesOn = !wasInGap && newest[newest.size() - 1].value == sample.value;
    if (goesOn && m_stands) {
        newest.holdUntil(sample.at);
        return true;
    }
    newest.append(sample);
    ++m_size;
    m_stands = goesOn;
    return true;
}

// Before the first sample nothing is known anyway.
void MemoryHistory::interrupt(Instant at)
{
    if (!isEmpty() && !isInGap())
        m_gaps.push_back({std::max(at, m_blocks.back().last()), Instant::max()});
}

std::optional<TimeSpan> MemoryHistory::span() const
{
    if (isEmpty())
        return {};
    return TimeSpan{m_blocks.front().first(), m_blocks.back().last() + Instant(1)};
}

// By where they begin, which is in the blocks themselves: where they end is in memory that is far away.
std::size_t MemoryHistory::blockAt(Instant at) const
{
    const auto begun =
        std::ranges::lower_bound(m_blocks, at, {}, [](const SampleBlock &block) { return block.first(); });
    const auto block = static_cast<std::size_t>(begun - m_blocks.begin());
    return block > 0 && m_blocks[block - 1].last() >= at ? block - 1 : block;
}

MemoryHistory::Position MemoryHistory::find(Instant at) const
{
    const std::size_t block = blockAt(at);
    return {block, block < m_blocks.size() ? m_blocks[block].indexAt(at) : 0};
}

Sample MemoryHistory::sampleBefore(Position position) const
{
    if (position.index > 0)
        return m_blocks[position.block][position.index - 1];
    const SampleBlock &before = m_blocks[position.block - 1];
    return before[before.size() - 1];
}

std::optional<Sample> MemoryHistory::newest() const
{
    return isEmpty() || isInGap() ? std::nullopt : at(m_blocks.back().last());
}

std::optional<Sample> MemoryHistory::at(Instant at) const
{
    const Position next = find(at + Instant(1));
    if ((next.block == 0 && next.index == 0) || at > m_blocks.back().last())
        return {};
    const Sample sample = sampleBefore(next);
    return hasGapAfter(sample.at, at) ? std::nullopt : std::optional(sample);
}

std::optional<Sample> MemoryHistory::after(Instant at) const
{
    const Position next = find(at + Instant(1));
    if (next.block == m_blocks.size())
        return {};
    const Sample sample = m_blocks[next.block][next.index];
    const bool isFirst = next.block == 0 && next.index == 0;
    const Instant before = isFirst ? at : std::max(at, sampleBefore(next).at);
    return hasGapAfter(before, sample.at - Instant(1)) ? std::nullopt : std::optional(sample);
}

// Whether a gap begins no earlier than `from` and before, or at, `until`.
bool MemoryHistory::hasGapAfter(Instant from, Instant until) const
{
    const auto gap = std::ranges::lower_bound(m_gaps, from, {}, &Gap::from);
    return gap != m_gaps.end() && gap->from <= until;
}

std::optional<Summary> MemoryHistory::summaryOf(Position begin, Position end) const
{
    std::optional<Summary> all;
    for (; begin.block < m_blocks.size() && begin.block <= end.block; begin = {begin.block + 1, 0}) {
        const SampleBlock &block = m_blocks[begin.block];
        const std::size_t last = begin.block == end.block ? end.index : block.size();
        if (begin.index >= last)
            continue;
        const Summary summary = block.summary(begin.index, last);
        all ? all->include(summary) : void(all = summary);
    }
    return all;
}

std::size_t MemoryHistory::count(const TimeSpan &span) const
{
    const Position begin = find(span.from);
    const Position end = find(span.to);
    std::size_t count = 0;
    for (std::size_t block = begin.block; block < end.block; ++block)
        count += m_blocks[block].size();
    return count + end.index - begin.index;
}

std::optional<Extent> MemoryHistory::extent(const TimeSpan &span) const
{
    const auto summary = summaryOf(find(span.from), find(span.to));
    return summary ? std::optional(summary->extent) : std::nullopt;
}

History::Columns MemoryHistory::columns(const TimeSpan &span, std::size_t count) const
{
    Columns columns(count);
    const auto edge = [&](std::size_t column) {
        return span.from +
               (span.to - span.from) * static_cast<std::int64_t>(column) / static_cast<std::int64_t>(count);
    };
    Position begin = find(span.from);
    for (std::size_t column = 0; column < count; ++column) {
        const Position end = find(edge(column + 1));
        if (const auto summary = summaryOf(begin, end)) {
            const Sample first = m_blocks[begin.block][begin.index];
            const Sample last = sampleBefore(end);
            const bool isFirst = begin.block == 0 && begin.index == 0;
            const Instant before = isFirst ? first.at : sampleBefore(begin).at;
            columns[column] = {*summary, first.value, last.value, hasGapAfter(before, last.at - Instant(1))};
        }
        begin = end;
    }
    return columns;
}

std::vector<History::Gap> MemoryHistory::gaps(const TimeSpan &span) const
{
    const auto begin = std::ranges::upper_bound(m_gaps, span.from, {}, &Gap::to);
    const auto end = std::ranges::lower_bound(m_gaps, span.to, {}, &Gap::from);
    return begin < end ? std::vector<Gap>(begin, end) : std::vector<Gap>();
}

void MemoryHistory::forEach(const TimeSpan &span, const With &with) const
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

// A value stands until the next sample or the next gap.
std::optional<MemoryHistory::Statistics> MemoryHistory::statistics(const TimeSpan &span) const
{
    const std::optional<Sample> first = at(span.from);
    std::optional<Extent> extremes = extent(span);
    if (first) {
        extremes = extremes.value_or(Extent{first->value, first->value});
        extremes->include({first->value, first->value});
    }
    if (!extremes)
        return {};
    const Instant end = std::min(span.to, m_blocks.back().last());
    Moments moments;
    Instant from = span.from;
    for (auto gap = std::ranges::lower_bound(m_gaps, from, {}, &Gap::to);
         gap != m_gaps.end() && gap->from < end; ++gap) {
        addMoments(moments, {from, gap->from});
        from = gap->to;
    }
    if (from < end)
        addMoments(moments, {from, end});
    const bool stoodNoTime = moments.stood() == Instant(0);
    return Statistics{*extremes, stoodNoTime ? static_cast<double>(extremes->least) : moments.mean(),
                      moments.deviation(), moments.stood()};
}

// Of a span without a gap: the value that stands at its begin, whole stretches of blocks, and what stands
// between them and at the end.
void MemoryHistory::addMoments(Moments &moments, const TimeSpan &span) const
{
    std::optional<Sample> standing;
    if (const Position next = find(span.from + Instant(1)); next.block > 0 || next.index > 0)
        standing = Sample{span.from, sampleBefore(next).value};
    for (std::size_t block = blockAt(span.from); block < m_blocks.size(); ++block) {
        const SampleBlock &samples = m_blocks[block];
        const std::size_t begin = samples.indexAt(span.from);
        const std::size_t end = samples.indexAt(span.to);
        if (begin < end) {
            if (standing)
                moments.add(standing->value, samples[begin].at - standing->at);
            moments.add(samples.moments(begin, end - 1));
            standing = samples[end - 1];
        }
        if (end < samples.size())
            break;
    }
    if (standing)
        moments.add(standing->value, span.to - standing->at);
}

void MemoryHistory::forgetOldest()
{
    if (m_blocks.size() < 2)
        return;
    m_bytes -= m_blocks.front().bytes();
    m_size -= m_blocks.front().size();
    m_blocks.pop_front();
    while (!m_gaps.empty() && m_gaps.front().to <= m_blocks.front().first())
        m_gaps.pop_front();
}

std::size_t MemoryHistory::bytes() const
{
    return isEmpty() ? 0 : m_bytes + m_blocks.back().bytes() + m_gaps.size() * sizeof(Gap);
}

std::optional<Instant> MemoryHistory::oldestBlockEnd() const
{
    return m_blocks.size() < 2 ? std::nullopt : std::optional(m_blocks.front().last());
}

} // namespace codewheel
