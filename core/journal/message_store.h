// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/message_table.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace codewheel {

// Keeps messages on disk, in a thread of its own, so that whoever adds one never waits. If the file cannot be
// used, the messages are kept in memory and a message says so (MessageId::notKept). Readers open a
// MessageTable at place(). Used by the window and tests.
class MessageStore
{
public:
    static constexpr qint64 defaultSize = 200'000'000;

    struct Settings
    {
        QString file;                     // empty: in memory only
        qint64 largestSize = defaultSize; // bytes; beyond it the oldest are dropped, a tenth at a time
    };

    // How long messages wait to be committed together with others. A fault does not wait.
    static constexpr std::chrono::milliseconds gathering{100};

    explicit MessageStore(Settings settings);
    // What was added is committed.
    ~MessageStore();
    MessageStore(const MessageStore &) = delete;
    MessageStore &operator=(const MessageStore &) = delete;

    void add(const Message &message, const QDateTime &at);
    // Waits until all that was added before is committed.
    void flush();

    // Empty until the file is open; a different one if the file fails.
    std::optional<DatabasePlace> place() const;
    // A reader found the file at `place` damaged: it is put aside.
    void reportBroken(const DatabasePlace &place, const DatabaseError &error);

private:
    using Batch = std::vector<StoredMessage>;

    void run(const std::stop_token &stop);
    Batch nextBatch(const std::stop_token &stop);
    void open();
    Stored<void> openFile();
    void openMemory(const Batch &newest);
    void give(DatabasePlace place);
    void write(const Batch &batch);
    void failed(const DatabaseError &error);
    void dropOldest();
    void tell(MessageCode id, Severity severity, std::vector<RefusalArgument> arguments);

    const Settings m_settings;

    // Shared by the threads.
    mutable std::mutex m_mutex;
    std::condition_variable_any m_added;
    std::condition_variable m_committed;
    Batch m_waiting;
    bool m_urgent = false;
    quint64 m_addedCount = 0;
    quint64 m_committedCount = 0;
    std::optional<DatabasePlace> m_place;
    std::optional<DatabaseError> m_reported;

    // Used by the writing thread only.
    std::optional<MessageTable> m_table;

    std::jthread m_thread; // last, so that it is destroyed first
};

} // namespace codewheel
