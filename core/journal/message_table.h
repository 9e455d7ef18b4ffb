// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/database.h"
#include "journal/message_filter.h"

#include <vector>

namespace codewheel {

// The database of messages through one connection (docs/journal.md): used by the thread that opened it.
// MessageStore writes to it, everybody else reads.
class MessageTable
{
public:
    static Stored<MessageTable> open(const DatabasePlace &place);

    // The existing ids: all from first to last. 0, 0: there is no message.
    struct Span
    {
        qint64 first = 0;
        qint64 last = 0;

        friend bool operator==(const Span &, const Span &) = default;
    };
    Stored<Span> span() const;
    // Rises when another connection, of whatever program, has changed the database.
    qint64 changes() const { return m_database.number(QStringLiteral("PRAGMA data_version")).value_or(0); }

    // All or, with an error, none. They get their ids here.
    Stored<void> append(const std::vector<StoredMessage> &messages) { return insert(messages, false); }
    // As they are, ids included.
    Stored<void> copy(const std::vector<StoredMessage> &messages) { return insert(messages, true); }

    // The messages with these ids, in this order; one that no longer exists has the id 0.
    Stored<std::vector<StoredMessage>> read(const std::vector<qint64> &ids) const;
    // Those from `first` to `last` that match the filter apart from its text, oldest first.
    Stored<std::vector<StoredMessage>> read(qint64 first, qint64 last,
                                            const MessageFilter &filter = {}) const;
    // The same, only the ids.
    Stored<std::vector<qint64>> ids(qint64 first, qint64 last, const MessageFilter &filter) const;
    // Where something happened, in order; a bus itself before its devices.
    std::vector<Place> places() const;

    qint64 size() const; // bytes
    // Drops the oldest, up to the id `last`, and releases the space.
    Stored<void> dropUpTo(qint64 last);

private:
    explicit MessageTable(Database database)
        : m_database(std::move(database))
    {}
    std::vector<Place> placesFor(const MessageFilter &filter) const;
    Stored<void> freePages();
    Stored<void> insert(const std::vector<StoredMessage> &messages, bool withIds);

    Database m_database;
};

} // namespace codewheel
