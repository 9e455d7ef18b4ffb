// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/history.h"
#include "journal/stored_message.h"
#include "recording/block_codec.h"
#include "recording/recording_entry.h"

#include <algorithm>
#include <map>

namespace codewheel {

// A time as a file has it, which may be any number: up to the year 9999.
constexpr Instant recordedTime(std::int64_t microseconds)
{
    constexpr std::int64_t latest = 253'402'300'800'000'000;
    return Instant(std::clamp<std::int64_t>(microseconds, 0, latest));
}

// What the samples of a channel that begin in a stretch of time have been: a row of the pyramid.
struct RecordedPiece
{
    Instant from{}; // the first sample; of a minute or an hour, where that begins
    Instant length{};
    std::uint64_t samples = 0;
    History::Column column;
};

struct BlockRow
{
    qint64 id = 0; // rises with each block
    qint64 channel = 0;
    RecordedPiece piece;
    QByteArray data; // packBlock()
};
struct DeviceRow
{
    qint64 id = 0;
    Place place{};
    Instant until{}; // its values stood until then, unless they are in a gap
};
struct ChannelRow
{
    qint64 id = 0;
    qint64 device = 0;
    Channel channel = Channel::position;
    std::optional<Instant> gapSince{}; // nothing is known from then on
};
// The widths of the rows above the blocks.
inline constexpr std::array<std::chrono::seconds, 2> pieceWidths{std::chrono::minutes(1),
                                                                 std::chrono::hours(1)};

struct SummaryRow
{
    qint64 channel = 0;
    RecordedPiece piece; // its length is one of pieceWidths
};

// What of a recording has yet to be written. Written twice, it is the same.
struct RecordingChanges
{
    std::vector<RecordedBus> buses{};
    std::map<qint64, DeviceRow> devices{}; // by id, like those below
    std::map<qint64, ChannelRow> channels{};
    std::map<qint64, BlockRow> blocks{};
    std::vector<std::pair<qint64, RecordedDescription>> descriptions{}; // by device
    std::vector<SummaryRow> summaries{};
    std::map<qint64, std::pair<Instant, StoredMessage>> messages{};
    std::vector<std::pair<qint64, RecordedTraffic>> traffic{}; // by id
    std::vector<RecordedNote> notes{};
    std::map<qint64, RecordedLoss> losses{};
    std::vector<RecordedClock> clocks{};
    Instant until{}; // of all

    bool isEmpty() const { return until == Instant(0) && buses.empty(); }
    std::size_t bytes() const; // of memory, roughly
};

} // namespace codewheel
