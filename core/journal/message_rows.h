// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/stored_message.h"

#include <deque>

namespace codewheel {

// What it takes to find the row of a message.
struct SightedMessage
{
    qint64 id = 0;
    qint64 day = 0;       // local, Julian
    quint64 likeness = 0; // see likeness()

    friend bool operator==(const SightedMessage &, const SightedMessage &) = default;
};

// Equal for messages that say the same about the same place, apart from figures that merely count. Never
// stored: another run of the program may give other numbers.
quint64 likeness(const StoredMessage &message);
SightedMessage sighted(const StoredMessage &message);

// How messages are arranged in rows: each day begins with a row of its own, and consecutive messages that are
// alike share one. Single messages, most of them, are kept as runs, so that a million of them need no memory.
// Grows at both ends.
class MessageRows
{
public:
    // The messages of a row, by their index among all that were given, oldest first.
    struct Row
    {
        qint64 first = 0;
        qint64 count = 0; // 0: no message, but the day of the first one

        bool isDay() const { return count == 0; }
        qint64 last() const { return first + count - 1; }

        friend bool operator==(const Row &, const Row &) = default;
    };

    qint64 size() const { return m_runs.empty() ? 0 : m_runs.back().endRow() - m_runs.front().row; }
    bool isEmpty() const { return m_runs.empty(); }
    Row at(qint64 row) const;

    void append(const SightedMessage &message);  // newer than all
    void prepend(const SightedMessage &message); // older than all
    // Whether it would share the row that is already there.
    bool joinsLast(const SightedMessage &newer) const { return !isEmpty() && areAlike(newer, m_newest); }
    bool joinsFirst(const SightedMessage &older) const { return !isEmpty() && areAlike(older, m_oldest); }
    qint64 firstDay() const { return m_oldest.day; }
    qint64 lastDay() const { return m_newest.day; }
    void dropFirst(qint64 messages);
    void clear() { m_runs.clear(); }

private:
    enum class Kind : std::uint8_t { day, single, alike };
    struct Run
    {
        qint64 row = 0;     // counted from where the first run began when it was made; may be negative
        qint64 message = 0; // likewise
        qint64 count = 0;   // messages
        Kind kind = Kind::single;

        qint64 endRow() const { return row + (kind == Kind::single ? count : 1); }
        qint64 endMessage() const { return message + count; }
    };

    static bool areAlike(const SightedMessage &one, const SightedMessage &other)
    {
        return one.day == other.day && one.likeness == other.likeness;
    }
    void addToLast(Run run);
    void putDayBefore();

    std::deque<Run> m_runs; // the first is a day
    SightedMessage m_oldest;
    SightedMessage m_newest;
};

} // namespace codewheel
