// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recorded_channel.h"

#include "history/moments.h"

#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

namespace codewheel {
namespace {

// Of a statement; another program may want to write between two of them.
constexpr int mostRows = 20'000;
constexpr int mostBlocks = 64;
constexpr std::size_t mostUnpacked = 1'000; // blocks, some 16 MB

const QString pieceSelection =
    QStringLiteral("start, length, samples, lowest, highest, ones_always, ones_ever, first, last, gap");

RecordedPiece pieceOf(const QSqlQuery &row)
{
    const auto number = [&row](int index) { return std::int64_t{row.value(index).toLongLong()}; };
    return {.from = recordedTime(number(0)),
            .length = recordedTime(number(1)),
            .samples = static_cast<std::uint64_t>(number(2)),
            .column = {.summary = {{number(3), number(4)},
                                   static_cast<std::uint32_t>(number(5)),
                                   static_cast<std::uint32_t>(number(6))},
                       .first = number(7),
                       .last = number(8),
                       .hasGap = number(9) != 0}};
}

template <class... Values>
QSqlQuery query(const SqlConnection &database, const QString &statement, Values... values)
{
    QSqlQuery query = database.query(statement);
    int index = 0;
    (query.bindValue(index++, qint64{values}), ...);
    return query;
}

// Calls `with` for each row.
template <class With>
Stored<void> read(const SqlConnection &database, QSqlQuery query, With with)
{
    if (auto done = database.run(query); !done)
        return done;
    while (query.next())
        with(query);
    return query.lastError().isValid() ? Stored<void>(tl::unexpected(database.reasonOf(query.lastError())))
                                       : Stored<void>();
}

std::optional<Instant> gapBefore(const RecordedBlock &block, std::size_t index)
{
    const auto gap = std::ranges::lower_bound(block.gaps, index, {}, &RecordedBlock::GapBefore::index);
    return gap != block.gaps.end() && gap->index == index ? std::optional(gap->from) : std::nullopt;
}

// It may have been written again, with more samples, since its row was read.
void endAt(RecordedBlock &block, Instant last)
{
    const auto behind = std::ranges::upper_bound(block.samples, last, {}, &Sample::at);
    block.samples.erase(behind, block.samples.end());
    std::erase_if(block.gaps, [&](const auto &gap) { return gap.index >= block.samples.size(); });
}

} // namespace

tl::unexpected<Refusal> RecordedChannel::refusal(const DatabaseError &error) const
{
    return tl::unexpected(Refusal{RefusalKind::link, RefusalId::databaseFailed, {m_file, error.reason}});
}

std::optional<Refusal> RecordedChannel::damage() const
{
    if (m_damaged.empty())
        return {};
    return Refusal{
        RefusalKind::link, RefusalId::damagedBlocks, {m_file, std::int64_t{std::ssize(m_damaged)}}};
}

Stored<void> RecordedChannel::findEnds()
{
    const auto statement =
        QStringLiteral("SELECT %1 FROM block WHERE channel = ? ORDER BY start %2, data %2 LIMIT 1");
    return codewheel::read(*m_database,
                           query(*m_database, statement.arg(pieceSelection, QStringLiteral("ASC")), m_id),
                           [this](const QSqlQuery &row) {
                               const RecordedPiece piece = pieceOf(row);
                               m_first = Sample{piece.from, piece.column.first};
                           })
        .and_then([&] {
            return codewheel::read(
                *m_database, query(*m_database, statement.arg(pieceSelection, QStringLiteral("DESC")), m_id),
                [this](const QSqlQuery &row) {
                    const RecordedPiece piece = pieceOf(row);
                    m_last = Sample{piece.from + piece.length, piece.column.last};
                });
        });
}

// The value that still stood when the recording had come that far is in no block as yet.
std::optional<Sample> RecordedChannel::held() const
{
    if (!m_last || m_limits.gapSince || m_limits.until <= m_last->at)
        return {};
    return Sample{m_limits.until, m_last->value};
}

Instant RecordedChannel::end() const
{
    const auto newest = held();
    return newest ? newest->at : m_last ? m_last->at : Instant(0);
}

std::optional<TimeSpan> RecordedChannel::span() const
{
    if (!m_first || !m_last || end() < m_limits.since)
        return {};
    return TimeSpan{std::max(m_first->at, m_limits.since), end() + Instant(1)};
}

// Of the block that may still have a sample of that time; `at` itself: there is none.
Stored<Instant> RecordedChannel::startBefore(Instant at) const
{
    Instant start = at;
    return codewheel::read(
               *m_database,
               query(*m_database,
                     QStringLiteral("SELECT max(start) FROM block WHERE channel = ? AND start < ?"), m_id,
                     at.count()),
               [&](const QSqlQuery &row) {
                   if (!row.value(0).isNull())
                       start = Instant(row.value(0).toLongLong());
               })
        .map([&] { return start; });
}

Stored<std::vector<RecordedChannel::Block>> RecordedChannel::blocksAfter(Instant from, qint64 id, Instant to,
                                                                         int most) const
{
    return blocks(
        query(*m_database,
              QStringLiteral("SELECT %1, data FROM block WHERE channel = ? AND (start, data) > (?, ?) "
                             "AND start < ? ORDER BY start, data LIMIT ?")
                  .arg(pieceSelection),
              m_id, from.count(), id, to.count(), most));
}

Stored<std::vector<RecordedChannel::Block>> RecordedChannel::blocks(QSqlQuery rows) const
{
    std::vector<Block> blocks;
    return codewheel::read(*m_database, std::move(rows),
                           [&](const QSqlQuery &row) {
                               blocks.push_back({row.value(10).toLongLong(), pieceOf(row)});
                           })
        .map([&] { return std::move(blocks); });
}

// A picture that moves shows the same blocks again and again. One that was read before it was full has become
// longer.
Stored<RecordedChannel::Unpacked> RecordedChannel::read(const Block &row)
{
    const auto isTheOne = [&row](const RecordedBlock &block) {
        return !block.samples.empty() && block.samples.front().at == row.piece.from &&
               block.samples.back().at == row.piece.from + row.piece.length;
    };
    if (const auto known = m_unpacked.find(row.id); known != m_unpacked.end() && isTheOne(*known->second))
        return known->second;
    QByteArray bytes;
    auto done = codewheel::read(
        *m_database, query(*m_database, QStringLiteral("SELECT data FROM samples WHERE id = ?"), row.id),
        [&](const QSqlQuery &found) { bytes = found.value(0).toByteArray(); });
    if (!done)
        return tl::unexpected(done.error());
    auto block = unpackBlock(bytes);
    if (block)
        endAt(*block, row.piece.from + row.piece.length);
    if (block && isTheOne(*block))
        return keep(row.id, *std::move(block));
    m_damaged.insert(row.id);
    return Unpacked();
}

RecordedChannel::Unpacked RecordedChannel::keep(qint64 id, RecordedBlock block)
{
    Unpacked &kept = m_unpacked[id];
    if (!kept)
        m_unpackedOrder.push_back(id);
    kept = std::make_shared<const RecordedBlock>(std::move(block));
    Unpacked its = kept;
    if (m_unpackedOrder.size() > mostUnpacked) {
        m_unpacked.erase(m_unpackedOrder.front());
        m_unpackedOrder.pop_front();
    }
    return its;
}

Result<RecordedChannel::Look> RecordedChannel::look(const TimeSpan &span, std::size_t count)
{
    if (count == 0 || span.to <= span.from)
        return Look{RecordingColumns::Columns(count), 0};
    RecordingColumns columns(span, count, m_limits.since);
    const Instant begin = std::max(span.from, m_limits.since);
    Instant from = begin;
    for (auto width = pieceWidths.rbegin(); width != pieceWidths.rend(); ++width) {
        if (!columns.isNarrow(*width))
            continue;
        const auto reached = addSummaries(columns, *width, {from, span.to});
        if (!reached)
            return refusal(reached.error());
        from = *reached;
    }
    if (from == begin) {
        const auto start = startBefore(from);
        if (!start)
            return refusal(start.error());
        from = *start;
    }
    if (auto added = addBlocks(columns, from, span.to); !added)
        return refusal(added.error());
    if (const auto newest = held())
        columns.add(*newest, false);
    const std::uint64_t samples = columns.samples();
    return Look{columns.take(), samples};
}

// Returns from when on there are no such rows as yet.
Stored<Instant> RecordedChannel::addSummaries(RecordingColumns &columns, std::chrono::seconds width,
                                              const TimeSpan &span) const
{
    Instant reached = span.from;
    Instant next = span.from - width + Instant(1);
    for (int rows = mostRows; rows == mostRows;) {
        rows = 0;
        const auto done = codewheel::read(
            *m_database,
            query(*m_database,
                  QStringLiteral("SELECT %1 FROM summary WHERE channel = ? AND length = ? AND start >= ? "
                                 "AND start < ? ORDER BY start LIMIT ?")
                      .arg(pieceSelection),
                  m_id, Instant(width).count(), next.count(), span.to.count(), mostRows),
            [&](const QSqlQuery &row) {
                const RecordedPiece piece = pieceOf(row);
                columns.add(piece);
                reached = piece.from + piece.length;
                next = piece.from + Instant(1);
                ++rows;
            });
        if (!done)
            return tl::unexpected(done.error());
    }
    return reached;
}

Stored<void> RecordedChannel::addBlocks(RecordingColumns &columns, Instant from, Instant to)
{
    Block last{-1, {from, {}, 0, {}}};
    while (true) {
        const auto rows = blocksAfter(last.piece.from, last.id, to, mostRows);
        if (!rows)
            return tl::unexpected(rows.error());
        for (const Block &row : *rows) {
            if (columns.takes(row.piece))
                columns.add(row.piece);
            else if (auto added = addSamples(columns, row); !added)
                return added;
        }
        if (rows->size() < mostRows)
            return {};
        last = rows->back();
    }
}

Stored<void> RecordedChannel::addSamples(RecordingColumns &columns, const Block &row)
{
    return read(row).map([&](const Unpacked &block) {
        auto gap = block ? block->gaps.begin() : std::vector<RecordedBlock::GapBefore>::const_iterator();
        for (std::size_t index = 0; block && index < block->samples.size(); ++index) {
            const bool isAfterGap = gap != block->gaps.end() && gap->index == index;
            gap += isAfterGap ? 1 : 0;
            columns.add(block->samples[index], isAfterGap);
        }
    });
}

Stored<std::optional<RecordedChannel::Block>> RecordedChannel::blockAt(Instant at) const
{
    std::optional<Block> found;
    return codewheel::read(*m_database,
                           query(*m_database,
                                 QStringLiteral("SELECT %1, data FROM block WHERE channel = ? AND start <= ? "
                                                "ORDER BY start DESC, data DESC LIMIT 1")
                                     .arg(pieceSelection),
                                 m_id, at.count()),
                           [&](const QSqlQuery &row) {
                               found = Block{row.value(10).toLongLong(), pieceOf(row)};
                           })
        .map([&] { return found; });
}

Result<std::optional<Sample>> RecordedChannel::at(Instant at)
{
    if (at < m_limits.since || at > end())
        return std::nullopt;
    const auto found = blockWith(at);
    if (!found)
        return refusal(found.error());
    if (*found == nullptr)
        return std::nullopt;
    const auto &[row, block] = **found;
    const std::vector<Sample> &samples = block->samples;
    const auto next =
        static_cast<std::size_t>(std::ranges::upper_bound(samples, at, {}, &Sample::at) - samples.begin());
    const auto inGap = isInGap(at, row, *block, next);
    if (!inGap)
        return refusal(inGap.error());
    return *inGap ? std::nullopt : std::optional(samples[next - 1]);
}

Stored<const RecordedChannel::AtHand *> RecordedChannel::blockWith(Instant at)
{
    if (m_atHand && at >= m_atHand->row.piece.from && at < m_atHand->end())
        return &*m_atHand;
    const auto row = blockAt(at);
    if (!row)
        return tl::unexpected(row.error());
    if (!*row)
        return nullptr;
    if (m_atHand && m_atHand->row.id == (*row)->id)
        return &*m_atHand;
    auto block = read(**row);
    if (!block)
        return tl::unexpected(block.error());
    if (!*block)
        return nullptr;
    m_atHand = AtHand{**row, *block};
    return &*m_atHand;
}

Result<std::optional<Summary>> RecordedChannel::summary(const TimeSpan &span)
{
    if (m_atHand && span.from > m_atHand->row.piece.from && span.to <= m_atHand->end()) {
        std::optional<Summary> all;
        for (const Sample &sample : m_atHand->block->samples)
            if (sample.at >= span.from && sample.at < span.to) {
                const auto word = static_cast<std::uint32_t>(sample.value);
                const Summary one{{sample.value, sample.value}, word, word};
                if (all)
                    all->include(one);
                else
                    all = one;
            }
        return all;
    }
    return look(span, 1).map([](const Look &look) {
        const auto &only = look.columns;
        return only.empty() || !only.front() ? std::nullopt : std::optional(only.front()->summary);
    });
}

// A damaged block has none.
Result<std::optional<Sample>> RecordedChannel::before(Instant at)
{
    if (const auto newest = held(); newest && newest->at < at)
        return newest;
    for (Instant until = at - Instant(1);;) {
        const auto row = blockAt(until);
        if (!row)
            return refusal(row.error());
        if (!*row || (*row)->piece.from + (*row)->piece.length < m_limits.since)
            return std::nullopt;
        const auto block = read(**row);
        if (!block)
            return refusal(block.error());
        if (*block) {
            const std::vector<Sample> &samples = (*block)->samples;
            const Sample found = *std::prev(std::ranges::lower_bound(samples, at, {}, &Sample::at));
            return found.at < m_limits.since ? std::nullopt : std::optional(found);
        }
        until = (*row)->piece.from - Instant(1);
    }
}

Result<std::optional<Sample>> RecordedChannel::after(Instant at)
{
    std::optional<Sample> found;
    return forEach({at + Instant(1), Instant::max()},
                   [&found](const Sample &sample, const auto &) {
                       found = sample;
                       return false;
                   })
        .map([&found] { return found; });
}

// `next`: the first sample behind that time, in the block or in the one after it.
Stored<bool> RecordedChannel::isInGap(Instant at, const Block &row, const RecordedBlock &block,
                                      std::size_t next)
{
    std::optional<Instant> from = gapBefore(block, next);
    if (next == block.samples.size()) {
        const auto rows = blocksAfter(row.piece.from, row.id, Instant::max(), 1);
        if (!rows)
            return tl::unexpected(rows.error());
        if (rows->empty())
            from = m_limits.gapSince;
        else if (rows->front().piece.column.hasGap) {
            const auto after = read(rows->front());
            if (!after)
                return tl::unexpected(after.error());
            if (*after)
                from = gapBefore(**after, 0);
        }
    }
    return from && *from <= at;
}

Result<void> RecordedChannel::forEach(const TimeSpan &span, const With &with)
{
    if (auto done = forEachSample({std::max(span.from, m_limits.since), span.to}, with); !done)
        return refusal(done.error());
    return {};
}

// Of those in the span, and the one behind it, before which a gap may have begun in the span.
Stored<std::vector<RecordedChannel::Block>> RecordedChannel::blocksWithGaps(const TimeSpan &span) const
{
    const auto start = startBefore(span.from);
    if (!start)
        return tl::unexpected(start.error());
    auto behind = blocksAfter(span.to - Instant(1), std::numeric_limits<qint64>::max(), Instant::max(), 1);
    if (!behind)
        return behind;
    std::erase_if(*behind, [](const Block &row) { return !row.piece.column.hasGap; });
    return blocks(query(*m_database,
                        QStringLiteral("SELECT %1, data FROM block WHERE channel = ? AND start >= ? AND "
                                       "start < ? AND gap != 0 ORDER BY start, data")
                            .arg(pieceSelection),
                        m_id, start->count(), span.to.count()))
        .map([&](std::vector<Block> found) {
            found.insert(found.end(), behind->begin(), behind->end());
            return found;
        });
}

Result<std::vector<History::Gap>> RecordedChannel::gaps(const TimeSpan &span)
{
    const auto rows = blocksWithGaps(span);
    if (!rows)
        return refusal(rows.error());
    std::vector<History::Gap> gaps;
    for (const Block &row : *rows) {
        const auto block = read(row);
        if (!block)
            return refusal(block.error());
        for (std::size_t i = 0; *block && i < (*block)->gaps.size(); ++i) {
            const auto &[index, from] = (*block)->gaps[i];
            const History::Gap gap{from, (*block)->samples[index].at};
            if (gap.from < span.to && gap.to > span.from)
                gaps.push_back(gap);
        }
    }
    if (m_limits.gapSince && *m_limits.gapSince < span.to)
        gaps.push_back({*m_limits.gapSince, Instant::max()});
    return gaps;
}

Stored<void> RecordedChannel::forEachSample(const TimeSpan &span, const With &with)
{
    const auto start = startBefore(span.from);
    if (!start)
        return tl::unexpected(start.error());
    Block last{-1, {*start, {}, 0, {}}};
    std::optional<Instant> damagedFrom;
    Instant before = *start;
    while (true) {
        const auto rows = blocksAfter(last.piece.from, last.id, span.to, mostBlocks);
        if (!rows)
            return tl::unexpected(rows.error());
        for (const Block &row : *rows) {
            const auto block = read(row);
            if (!block)
                return tl::unexpected(block.error());
            if (!*block)
                damagedFrom = damagedFrom.value_or(before);
            for (std::size_t index = 0; *block && index < (*block)->samples.size(); ++index) {
                const Sample &sample = (*block)->samples[index];
                const auto damaged = std::exchange(damagedFrom, std::nullopt);
                before = sample.at;
                if (sample.at >= span.from && sample.at < span.to &&
                    !with(sample, damaged ? damaged : gapBefore(**block, index)))
                    return {};
            }
        }
        if (rows->size() < mostBlocks)
            break;
        last = rows->back();
    }
    const auto newest = held();
    if (newest && newest->at >= span.from && newest->at < span.to)
        (void)with(*newest, damagedFrom);
    return {};
}

Result<std::optional<History::Statistics>> RecordedChannel::statistics(const TimeSpan &span)
{
    const auto first = at(span.from);
    if (!first)
        return tl::unexpected(first.error());
    std::optional<Sample> standing = *first;
    std::optional<Extent> extent;
    Moments moments;
    const auto include = [&](std::int64_t value) {
        extent = extent.value_or(Extent{value, value});
        extent->include({value, value});
    };
    const auto standUntil = [&](Instant until) {
        moments.add(standing->value, std::min(until, span.to) - std::max(standing->at, span.from));
    };
    if (standing)
        include(standing->value);
    bool goesOn = true;
    const auto done = forEach({span.from, Instant::max()}, [&](const Sample &sample, const auto &gapFrom) {
        if (standing)
            standUntil(gapFrom.value_or(sample.at));
        goesOn = sample.at < span.to;
        if (goesOn) {
            include(sample.value);
            standing = sample;
        }
        return goesOn;
    });
    if (!done)
        return tl::unexpected(done.error());
    if (!standing || !extent)
        return std::nullopt;
    if (goesOn)
        standUntil(m_limits.gapSince.value_or(end()));
    const bool stoodNoTime = moments.stood() == Instant(0);
    return History::Statistics{*extent, stoodNoTime ? static_cast<double>(standing->value) : moments.mean(),
                               moments.deviation(), moments.stood()};
}

} // namespace codewheel
