// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/ledger.h"

namespace codewheel {

// A file beside a ledger for entries that could not be made there, one line each (docs/journal.md). Its space
// is reserved when it is created, so that there is some when the disk is full. It belongs to this program as
// long as the object lives, by a lock; if nothing was added it is removed then, otherwise the next one that
// opens the ledger takes in its entries. Used by SafeLedger.
class WaitingEntries
{
public:
    static constexpr qint64 room = 16'384; // bytes, about ten jobs

    // isThere() tells whether the file could be created, with some space.
    explicit WaitingEntries(const QString &ledger);
    WaitingEntries(const WaitingEntries &) = delete;
    WaitingEntries &operator=(const WaitingEntries &) = delete;
    ~WaitingEntries();

    bool isThere() const { return m_file >= 0; }
    const QString &path() const { return m_path; }

    // On disk when it returns; false: there is no room for it either.
    bool add(const Ledger::Record &record);

private:
    bool takeRoom() const;

    QString m_path;
    int m_file = -1;
    qint64 m_used = 0;
};

// What programs that have ended left beside a ledger.
class LeftEntries
{
public:
    explicit LeftEntries(const QString &path);
    LeftEntries(LeftEntries &&other) noexcept;
    LeftEntries &operator=(LeftEntries &&) = delete;
    ~LeftEntries();

    // Nobody holds it any more.
    bool isLeft() const { return m_file >= 0; }
    // An unfinished line is left out. Empty: it holds something else, and is left alone.
    std::optional<std::vector<Ledger::Record>> records() const;
    void drop();

    static QStringList filesBeside(const QString &ledger);

private:
    QString m_path;
    int m_file = -1;
};

} // namespace codewheel
