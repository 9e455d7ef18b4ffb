// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recorded_history.h"

#include "recording/recording_archive.h"

namespace codewheel {
namespace {

constexpr std::size_t usualColumns = 1'000;   // of a picture
constexpr std::size_t mostAtOnce = 1'000'000; // samples, which takes a frame or two

} // namespace

template <class What>
What RecordedHistory::valueOr(Result<What> result, What other) const
{
    if (result)
        return std::move(*result);
    m_archive.tell(result.error());
    return other;
}

Instant RecordedHistory::recorded(Instant at) const
{
    return at == Instant::max() ? at : at - m_archive.shift();
}

TimeSpan RecordedHistory::recorded(const TimeSpan &span) const
{
    return {recorded(span.from), recorded(span.to)};
}

Sample RecordedHistory::shown(const Sample &sample) const
{
    return {sample.at + m_archive.shift(), sample.value};
}

std::optional<TimeSpan> RecordedHistory::span() const
{
    const auto span = m_channel.span();
    return span ? std::optional(TimeSpan{span->from + m_archive.shift(), span->to + m_archive.shift()})
                : std::nullopt;
}

std::optional<Sample> RecordedHistory::newest() const
{
    const auto all = span();
    return all ? at(all->to - Instant(1)) : std::nullopt;
}

std::optional<Sample> RecordedHistory::at(Instant at) const
{
    const auto sample = valueOr<std::optional<Sample>>(m_channel.at(recorded(at)), {});
    return sample ? std::optional(shown(*sample)) : std::nullopt;
}

std::optional<Sample> RecordedHistory::after(Instant at) const
{
    const Instant from = recorded(at);
    std::optional<Sample> next;
    const auto done = m_channel.forEach({from + Instant(1), Instant::max()},
                                        [&](const Sample &sample, const auto &gapFrom) {
                                            if (!gapFrom || *gapFrom < from)
                                                next = shown(sample);
                                            return false;
                                        });
    if (!done)
        m_archive.tell(done.error());
    return next;
}

// Whoever asks for one thing of a span asks for the others next.
const RecordedChannel::Look &RecordedHistory::look(const TimeSpan &span, std::size_t count) const
{
    if (m_seen == span && m_seenColumns == count)
        return m_look;
    m_look = valueOr<RecordedChannel::Look>(m_channel.look(span, count), {Columns(count), 0});
    m_seen = span;
    m_seenColumns = count;
    m_archive.tellDamage(m_channel.damage());
    return m_look;
}

std::size_t RecordedHistory::count(const TimeSpan &span) const
{
    return look(recorded(span), m_seenColumns == 0 ? usualColumns : m_seenColumns).samples;
}

std::optional<Extent> RecordedHistory::extent(const TimeSpan &span) const
{
    std::optional<Extent> extent;
    for (const auto &column :
         look(recorded(span), m_seenColumns == 0 ? usualColumns : m_seenColumns).columns) {
        if (!column)
            continue;
        extent = extent.value_or(column->summary.extent);
        extent->include(column->summary.extent);
    }
    return extent;
}

History::Columns RecordedHistory::columns(const TimeSpan &span, std::size_t count) const
{
    return look(recorded(span), count).columns;
}

std::optional<History::Statistics> RecordedHistory::statistics(const TimeSpan &span) const
{
    if (count(span) > mostAtOnce)
        return m_archive.slowStatistics(m_key, recorded(span));
    return valueOr<std::optional<Statistics>>(m_channel.statistics(recorded(span)), {});
}

std::vector<History::Gap> RecordedHistory::gaps(const TimeSpan &span) const
{
    auto gaps = valueOr<std::vector<Gap>>(m_channel.gaps(recorded(span)), {});
    for (Gap &gap : gaps)
        gap = {gap.from + m_archive.shift(), gap.to == Instant::max() ? gap.to : gap.to + m_archive.shift()};
    return gaps;
}

void RecordedHistory::forEach(const TimeSpan &span, const With &with) const
{
    const auto done = m_channel.forEach(recorded(span), [&](const Sample &sample, const auto &) {
        with(shown(sample));
        return true;
    });
    if (!done)
        m_archive.tell(done.error());
}

} // namespace codewheel
