// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recording_changes.h"

#include <array>

namespace codewheel {

// The samples of one channel on their way into a recording: packed into blocks, with the summaries above
// them. While the value stands, only its first and its newest sample are kept, as in a History.
class ChannelBlocks
{
public:
    // A block ends with the first write when it has that many samples, and in any case before a sample that
    // is further from its first one than that.
    static constexpr std::size_t enough = 512;
    static constexpr Instant longest = std::chrono::seconds(10);

    // `nextBlock`: the id of the next block of the recording.
    ChannelBlocks(qint64 id, qint64 device, Channel channel, qint64 &nextBlock)
        : m_row{id, device, channel, {}}
        , m_nextBlock(&nextBlock)
    {}

    const ChannelRow &row() const { return m_row; }
    // What is older than what came before is left out.
    void append(const Sample &sample, RecordingChanges &changes);
    void interrupt(Instant at, RecordingChanges &changes);
    // Everything so far. A block that has room is written again next time.
    void write(RecordingChanges &changes);

private:
    void push(const Sample &sample, std::optional<Instant> gapFrom, RecordingChanges &changes);
    void pushNewestOfRun(RecordingChanges &changes);
    RecordedPiece piece() const;
    void writeBlock(RecordingChanges &changes);
    void close(RecordingChanges &changes);
    void sum(const RecordedPiece &piece, RecordingChanges &changes);

    ChannelRow m_row;
    qint64 *m_nextBlock;
    std::optional<Sample> m_last; // that was put into a block
    Instant m_newest{};           // m_last stood until then
    qint64 m_block = 0;           // 0: none is open
    RecordedBlock m_open{};
    bool m_isWritten = true;
    std::array<std::optional<RecordedPiece>, pieceWidths.size()> m_sums;
};

} // namespace codewheel
