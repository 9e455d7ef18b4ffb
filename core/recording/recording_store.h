// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/database.h"
#include "recording/recording_changes.h"

#include <memory>

namespace codewheel {

// What stands at the head of a recording.
struct RecordingHead
{
    QString program; // and its version
    QString zone;    // the time zone of the computer, "Europe/Berlin"
    Instant begun{};
    Instant since{}; // what is older is not there any more; 0: all is there
    Instant until{};
    bool hasEnded = false; // else it is still being written, or its program was killed

    friend bool operator==(const RecordingHead &, const RecordingHead &) = default;
};

// The tables of a recording, in a file or on a server, written to through one connection
// (docs/recording-files.md): used by the thread that opened it.
class RecordingStore
{
public:
    static Stored<void> create(const QString &file, const RecordingHead &head);
    static Stored<RecordingStore> open(const QString &file);
    // A database that has these tables already.
    explicit RecordingStore(std::shared_ptr<const SqlConnection> database)
        : m_database(std::move(database))
    {}

    Stored<void> begin(const RecordingHead &head);

    // All or, with an error, nothing.
    Stored<void> write(const RecordingChanges &changes);
    // Leaves out what ended before that; its room is for what comes. A value that stood then stays known.
    Stored<void> forgetBefore(Instant at);
    Stored<void> end(Instant at);
    qint64 usedBytes() const; // of a file

private:
    using Values = std::vector<QVariant>;
    template <class Rows, class ValuesOf>
    Stored<void> put(const QString &statement, const Rows &rows, ValuesOf valuesOf);
    Stored<void> run(const QString &statement, const Values &values);
    Stored<void> writeDevices(const RecordingChanges &changes);
    Stored<void> writeBlocks(const RecordingChanges &changes);
    Stored<void> writeEvents(const RecordingChanges &changes);
    Stored<void> writeNotes(const RecordingChanges &changes);
    Stored<void> forgetBefore(Instant at, qint64 channel);
    Stored<std::vector<qint64>> channels() const;

    std::shared_ptr<const SqlConnection> m_database;
};

} // namespace codewheel
