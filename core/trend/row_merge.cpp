// SPDX-License-Identifier: GPL-3.0-or-later
#include "trend/row_merge.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr std::size_t samplesAtOnce = 8'192; // of all columns together
constexpr std::size_t samplesOfColumn = 64;  // so that a stretch is worth looking into each of many columns

} // namespace

RowMerge::RowMerge(const TrendExtract &extract, HistoryOf historyOf)
    : m_historyOf(std::move(historyOf))
    , m_span(extract.span)
    , m_reached(extract.span.from)
    , m_stretch(extract.span.to - extract.span.from)
    , m_cells(extract.columns.size())
    , m_isDone(extract.span.from >= extract.span.to)
{
    for (const TrendColumn &column : extract.columns)
        m_columns.push_back({.track = column.track});
}

bool RowMerge::next(const TakeRow &take)
{
    if (m_isDone)
        return false;
    const TimeSpan stretch{m_reached, endOfStretch()};
    m_stretch = stretch.to - stretch.from;
    for (Column &column : m_columns)
        column.load(m_historyOf(column.track), stretch);
    if (!m_isOpen)
        open(take);
    while (const auto at = nextRow()) {
        for (Column &column : m_columns)
            if (column.next < column.events.size() && column.events[column.next].at == *at)
                column.value = column.events[column.next++].value;
        give(*at, take);
    }
    m_reached = stretch.to;
    if (m_reached < m_span.to)
        return true;
    close(take);
    m_isDone = true;
    return false;
}

double RowMerge::part() const
{
    const auto seconds = [](Instant length) { return std::chrono::duration<double>(length).count(); };
    return m_isDone ? 1 : seconds(m_reached - m_span.from) / seconds(m_span.to - m_span.from);
}

// So much at once that the memory it takes does not depend on the span.
Instant RowMerge::endOfStretch() const
{
    const std::size_t most = std::max(samplesAtOnce, samplesOfColumn * m_columns.size());
    Instant end = std::min(m_span.to, m_reached + 2 * m_stretch);
    while (end - m_reached > Instant(1) && samplesIn({m_reached, end}) > most)
        end = m_reached + (end - m_reached) / 2;
    return end;
}

std::size_t RowMerge::samplesIn(const TimeSpan &span) const
{
    std::size_t samples = 0;
    for (const Column &column : m_columns)
        if (const History *history = m_historyOf(column.track))
            samples += history->count(span);
    return samples;
}

void RowMerge::Column::load(const History *history, const TimeSpan &stretch)
{
    events.clear();
    next = 0;
    const auto all = history != nullptr ? history->span() : std::nullopt;
    knownUntil = all ? all->to : Instant::min();
    if (!all)
        return;
    history->forEach(stretch, [this](const Sample &sample) { events.push_back({sample.at, sample.value}); });
    addGaps(*history, stretch);
}

// A sample may be as old as the gap that follows it, and comes first. A gap of no length is none.
void RowMerge::Column::addGaps(const History &history, const TimeSpan &stretch)
{
    const auto samples = static_cast<std::ptrdiff_t>(events.size());
    for (const History::Gap &gap : history.gaps(stretch))
        if (gap.from >= stretch.from && gap.from < gap.to)
            events.push_back({gap.from, {}});
    std::inplace_merge(events.begin(), events.begin() + samples, events.end(),
                       [](const Event &one, const Event &other) { return one.at < other.at; });
}

std::optional<Instant> RowMerge::nextRow() const
{
    std::optional<Instant> first;
    for (const Column &column : m_columns)
        if (column.next < column.events.size())
            first = std::min(first.value_or(Instant::max()), column.events[column.next].at);
    return first;
}

// With what has stood since before the span.
void RowMerge::open(const TakeRow &take)
{
    m_isOpen = true;
    bool stands = false;
    for (Column &column : m_columns) {
        const History *history = m_historyOf(column.track);
        const auto before = history != nullptr ? history->at(m_span.from - Instant(1)) : std::nullopt;
        column.value = before ? std::optional(before->value) : std::nullopt;
        stands = stands || (column.value && m_span.from < column.knownUntil);
    }
    if (stands && nextRow() != m_span.from)
        give(m_span.from, take);
}

// All rows so far are older than the end of the span.
void RowMerge::close(const TakeRow &take)
{
    bool stands = false;
    for (Column &column : m_columns) {
        const History *history = m_historyOf(column.track);
        const auto last = history != nullptr ? history->at(m_span.to) : std::nullopt;
        column.value = last ? std::optional(last->value) : std::nullopt;
        stands = stands || column.value;
    }
    if (stands)
        give(m_span.to, take);
}

void RowMerge::give(Instant at, const TakeRow &take)
{
    std::ranges::transform(m_columns, m_cells.begin(), [at](const Column &column) {
        return at < column.knownUntil ? column.value : std::nullopt;
    });
    take(at, m_cells);
}

} // namespace codewheel
