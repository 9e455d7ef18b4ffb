// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/sql_connection.h"
#include "recording/recording_columns.h"
#include "vocabulary/refusal.h"

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>

namespace codewheel {

// One channel of a recording: the same questions as a History has, answered from the file. Belongs to its
// RecordingReader, which outlives it, and to its thread. Knows how far the recording had come when it was
// made.
class RecordedChannel
{
public:
    // Before the sample nothing was known, from `gapFrom` on. Returns whether the next one is wanted.
    using With = std::function<bool(const Sample &sample, const std::optional<Instant> &gapFrom)>;
    // What a picture of a span needs: its columns, and how many samples are in them, or a few more.
    struct Look
    {
        RecordingColumns::Columns columns;
        std::uint64_t samples = 0;
    };

    // From the first sample to just behind the last one; nothing: there is none.
    std::optional<TimeSpan> span() const;
    // As History has them; where a column is wider than two blocks of samples, what is at its edge may be
    // counted with the column beside it.
    Result<Look> look(const TimeSpan &span, std::size_t count);
    Result<std::optional<Sample>> at(Instant at);
    // What its samples of the span have been; nothing: there is none.
    Result<std::optional<Summary>> summary(const TimeSpan &span);
    // The newest sample before that time, and the first one behind it, whatever gaps lie between.
    Result<std::optional<Sample>> before(Instant at);
    Result<std::optional<Sample>> after(Instant at);
    Result<std::optional<History::Statistics>> statistics(const TimeSpan &span);
    // Each sample of the span, oldest first, read piece by piece.
    Result<void> forEach(const TimeSpan &span, const With &with);

    // Those that reach into the span, oldest first, as History has them.
    Result<std::vector<History::Gap>> gaps(const TimeSpan &span);

    // Some of what was read so far is damaged: there are gaps instead. Nothing: all was whole.
    std::optional<Refusal> damage() const;

private:
    friend class RecordingReader;
    struct Block
    {
        qint64 id = 0;
        RecordedPiece piece;
    };
    using Unpacked = std::shared_ptr<const RecordedBlock>; // null: it is damaged, or was left out meanwhile

    // The block that was looked at last: who looks at one moment after the other mostly needs it again.
    struct AtHand
    {
        Block row;
        Unpacked block; // not null

        Instant end() const { return row.piece.from + row.piece.length; }
    };
    struct Limits
    {
        Instant since{}; // what is older is not there any more
        Instant until{}; // the last value stood until then
        std::optional<Instant> gapSince{};
    };

    RecordedChannel(const SqlConnection &database, QString file, qint64 id, const Limits &limits)
        : m_database(&database)
        , m_file(std::move(file))
        , m_id(id)
        , m_limits(limits)
    {}
    Stored<void> findEnds();
    Instant end() const; // of what is known
    std::optional<Sample> held() const;
    Stored<Instant> startBefore(Instant at) const;
    Stored<Instant> addSummaries(RecordingColumns &columns, std::chrono::seconds width,
                                 const TimeSpan &span) const;
    Stored<void> addBlocks(RecordingColumns &columns, Instant from, Instant to);
    Stored<void> addSamples(RecordingColumns &columns, const Block &row);
    Stored<Unpacked> read(const Block &row);
    Stored<const AtHand *> blockWith(Instant at); // null: there is none, or it is damaged
    Unpacked keep(qint64 id, RecordedBlock block);
    Stored<std::vector<Block>> blocks(QSqlQuery rows) const;
    Stored<std::vector<Block>> blocksWithGaps(const TimeSpan &span) const;
    Stored<std::vector<Block>> blocksAfter(Instant from, qint64 id, Instant to, int most) const;
    Stored<std::optional<Block>> blockAt(Instant at) const;
    Stored<bool> isInGap(Instant at, const Block &row, const RecordedBlock &block, std::size_t next);
    Stored<void> forEachSample(const TimeSpan &span, const With &with);
    tl::unexpected<Refusal> refusal(const DatabaseError &error) const;

    const SqlConnection *m_database;
    QString m_file;
    qint64 m_id;
    Limits m_limits;
    std::optional<Sample> m_first;
    std::optional<Sample> m_last; // that is in a block
    std::optional<AtHand> m_atHand;
    std::set<qint64> m_damaged; // ids of blocks
    std::map<qint64, Unpacked> m_unpacked;
    std::deque<qint64> m_unpackedOrder; // which was unpacked first
};

} // namespace codewheel
