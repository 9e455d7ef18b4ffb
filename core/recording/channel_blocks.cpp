// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/channel_blocks.h"

namespace codewheel {
namespace {

Instant floored(Instant at, std::chrono::seconds width)
{
    return at - at % Instant(width);
}

void addLater(RecordedPiece &sum, const RecordedPiece &piece)
{
    sum.samples += piece.samples;
    sum.column.summary.include(piece.column.summary);
    sum.column.last = piece.column.last;
    sum.column.hasGap = sum.column.hasGap || piece.column.hasGap;
}

} // namespace

void ChannelBlocks::append(const Sample &sample, RecordingChanges &changes)
{
    const std::optional<Instant> gapFrom = m_row.gapSince;
    if (sample.at < gapFrom.value_or(m_newest) || sample.at < Instant(0))
        return;
    if (gapFrom) {
        m_row.gapSince.reset();
        changes.channels.insert_or_assign(m_row.id, m_row);
    } else if (m_last && m_last->value == sample.value) {
        m_newest = sample.at;
        return;
    }
    pushNewestOfRun(changes);
    push(sample, gapFrom, changes);
}

// The value stood until then, and is another one now.
void ChannelBlocks::pushNewestOfRun(RecordingChanges &changes)
{
    if (m_last && m_newest > m_last->at)
        push({m_newest, m_last->value}, {}, changes);
}

// Before the first sample nothing is known anyway.
void ChannelBlocks::interrupt(Instant at, RecordingChanges &changes)
{
    if (!m_last || m_row.gapSince)
        return;
    pushNewestOfRun(changes);
    m_row.gapSince = std::max(at, m_newest);
    changes.channels.insert_or_assign(m_row.id, m_row);
}

void ChannelBlocks::push(const Sample &sample, std::optional<Instant> gapFrom, RecordingChanges &changes)
{
    if (m_block != 0 &&
        (m_open.samples.size() == RecordedBlock::most || sample.at > m_open.samples.front().at + longest))
        close(changes);
    if (m_block == 0)
        m_block = (*m_nextBlock)++;
    if (gapFrom)
        m_open.gaps.push_back({m_open.samples.size(), *gapFrom});
    m_open.samples.push_back(sample);
    m_isWritten = false;
    m_last = sample;
    m_newest = sample.at;
}

void ChannelBlocks::write(RecordingChanges &changes)
{
    if (m_block != 0 && m_open.samples.size() >= enough)
        close(changes);
    else
        writeBlock(changes);
}

RecordedPiece ChannelBlocks::piece() const
{
    const Sample &first = m_open.samples.front();
    const Sample &last = m_open.samples.back();
    return {first.at,
            last.at - first.at,
            m_open.samples.size(),
            {m_open.summary(), first.value, last.value, m_open.hasGap()}};
}

void ChannelBlocks::writeBlock(RecordingChanges &changes)
{
    if (!std::exchange(m_isWritten, true))
        changes.blocks.insert_or_assign(m_block, BlockRow{m_block, m_row.id, piece(), packBlock(m_open)});
}

void ChannelBlocks::close(RecordingChanges &changes)
{
    writeBlock(changes);
    sum(piece(), changes);
    m_open = {};
    m_block = 0;
}

// A minute or an hour is written once a block of a later one has ended, so that what it says never changes.
void ChannelBlocks::sum(const RecordedPiece &piece, RecordingChanges &changes)
{
    for (std::size_t level = 0; level < pieceWidths.size(); ++level) {
        std::optional<RecordedPiece> &sum = m_sums.at(level);
        const Instant from = floored(piece.from, pieceWidths.at(level));
        if (sum && sum->from == from) {
            addLater(*sum, piece);
            continue;
        }
        if (sum)
            changes.summaries.push_back({m_row.id, *sum});
        sum = piece;
        sum->from = from;
        sum->length = pieceWidths.at(level);
    }
}

} // namespace codewheel
