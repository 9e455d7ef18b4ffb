// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recording_composer.h"
#include "recording/recording_growth.h"
#include "recording/recording_store.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace codewheel {

struct RecordingSettings
{
    QString file;
    QString program{}; // and its version
    QString zone{};    // the time zone of the computer
    Instant begun{};
    // Once it is that long, or that large, what is oldest gives way; 0: it is not.
    Instant keptFor{};
    std::int64_t largestSize = 0;         // bytes
    std::int64_t leastFree = 100'000'000; // bytes of the disk that others may need
    std::size_t mostWaiting = 64'000'000; // bytes of memory, while the file cannot be written
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
};

// Writes what comes to a file, once a second, in a thread of its own, so that whoever adds something never
// waits. What cannot be written waits in memory; what has no room there is lost, counted, and a gap. Used by
// window, command line and tests.
class RecordingWriter
{
public:
    static constexpr std::chrono::milliseconds gathering{1'000};

    // Makes the file; refused if there is one.
    static Result<std::unique_ptr<RecordingWriter>> begin(const RecordingSettings &settings);
    ~RecordingWriter();
    RecordingWriter(const RecordingWriter &) = delete;
    RecordingWriter &operator=(const RecordingWriter &) = delete;

    void add(RecordingEntry entry);
    // Waits until what was added before is written, or could not be.
    void flush();
    RecordingStatus status() const;
    // Writes what was added, if it can be, and ends; nothing can be added from then on.
    RecordingStatus end();

private:
    struct FileIdentity
    {
        std::uint64_t device = 0;
        std::uint64_t node = 0;

        friend bool operator==(const FileIdentity &, const FileIdentity &) = default;
    };
    struct Lost
    {
        Instant since{};
        std::uint64_t count = 0;
    };

    explicit RecordingWriter(RecordingSettings settings);

    void lose(const RecordingEntry &entry);
    void tellLost(Place place);
    void tellAllLost();
    void put(RecordingEntry entry);

    void run(const std::stop_token &stop);
    std::vector<RecordingEntry> nextEntries(const std::stop_token &stop, bool &mustWrite);
    void commit();
    std::optional<Refusal> obstacle();
    Stored<void> keepLimits(Instant until);
    static std::optional<FileIdentity> identityOf(const QString &path);
    void tell(const RecordingChanges &changes, const std::optional<Refusal> &problem, bool hasEnded);

    const RecordingSettings m_settings;

    // Shared by the threads.
    mutable std::mutex m_mutex;
    std::condition_variable_any m_added;
    std::condition_variable m_done;
    std::vector<RecordingEntry> m_waiting;
    std::size_t m_waitingBytes = 0;
    std::size_t m_keptBytes = 0; // composed, and not yet written
    bool m_mustWrite = false;
    std::uint64_t m_addedCount = 0;
    std::uint64_t m_doneCount = 0;
    std::map<Place, Lost> m_lost; // not yet told to the recording; a place without a bus: of none
    RecordingStatus m_status;

    // Used by the writing thread only.
    RecordingComposer m_composer;
    std::optional<RecordingStore> m_store;
    std::optional<FileIdentity> m_identity;
    RecordingGrowth m_growth;
    Instant m_since{};
    bool m_hasEnded = false;

    std::jthread m_thread; // last, so that it is destroyed first
};

} // namespace codewheel
