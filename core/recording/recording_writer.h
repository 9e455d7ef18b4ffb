// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recording_composer.h"
#include "recording/recording_growth.h"
#include "recording/recording_store.h"
#include "recording/recording_target.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace codewheel {

// Of the disk where the file is, or is to be; 0 where that cannot be told.
std::int64_t freeBytesAt(const QString &file);

// Writes what comes to a file, once a second, in a thread of its own. What cannot be written waits in memory;
// what has no room there is lost, counted, and a gap.
class RecordingWriter final : public RecordingTarget
{
public:
    static constexpr std::chrono::milliseconds gathering{1'000};

    // Makes the file; refused if there is one.
    static Result<std::unique_ptr<RecordingWriter>> begin(const RecordingSettings &settings);
    ~RecordingWriter() override;

    void add(RecordingEntry entry) override;
    void flush() override;
    RecordingStatus status() const override;
    RecordingStatus end() override;

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
