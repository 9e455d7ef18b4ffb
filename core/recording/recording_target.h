// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recording_entry.h"
#include "vocabulary/refusal.h"

#include <memory>

namespace codewheel {

// Where to, and how much.
struct RecordingSettings
{
    QString file{};    // of a recording on a server: empty
    QString server{};  // postgresql://...: its address; empty: into the file
    QString program{}; // and its version
    QString zone{};    // the time zone of the computer
    Instant begun{};
    // Once it is that long, or that large, what is oldest gives way; 0: it is not.
    Instant keptFor{};
    std::int64_t largestSize = 0;         // bytes
    std::int64_t leastFree = 100'000'000; // bytes of the disk that others may need
    std::size_t mostWaiting = 64'000'000; // bytes of memory, while the file cannot be written
    QString unsentFolder{};               // what waits for its server; empty: the user's
};

// How the server of a recording gets on.
struct ServerStatus
{
    QString address; // of the recording itself, as RecordingReader::open() takes it
    bool isConnected = false;
    std::chrono::seconds lasts{};  // it has been connected, or not, for so long
    std::int64_t waitingBytes = 0; // on this computer, until it is back
};

// How a recording gets on.
struct RecordingStatus
{
    Instant written{}; // everything up to then is in the file
    std::int64_t bytes = 0;
    std::int64_t freeBytes = 0;             // of the disk
    std::optional<Instant> timeUntilFull{}; // the disk, or the largest size; nothing: not known, or never
    std::uint64_t lost = 0;                 // values there was no room for
    std::optional<Refusal>
        problem{}; // why nothing can be written; it goes on once that is over, or has ended
    bool hasEnded = false;
    std::optional<ServerStatus> server{}; // nothing: it is a file
};

// What a recording goes to: a file, or a server. Whoever adds something never waits. Used by window, command
// line and tests.
class RecordingTarget
{
public:
    // As the settings say.
    static Result<std::unique_ptr<RecordingTarget>> begin(const RecordingSettings &settings);
    virtual ~RecordingTarget() = default;
    RecordingTarget(const RecordingTarget &) = delete;
    RecordingTarget &operator=(const RecordingTarget &) = delete;

    virtual void add(RecordingEntry entry) = 0;
    // Waits until what was added before is written, or could not be.
    virtual void flush() = 0;
    virtual RecordingStatus status() const = 0;
    // Writes what was added, if it can be, and ends; nothing can be added from then on.
    virtual RecordingStatus end() = 0;

protected:
    RecordingTarget() = default;
};

} // namespace codewheel
