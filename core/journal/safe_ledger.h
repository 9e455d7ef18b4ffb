// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/waiting_entries.h"
#include "vocabulary/message.h"

#include <functional>
#include <map>
#include <memory>

namespace codewheel {

// A ledger that can be written to whatever becomes of its file. If that cannot be used, or fails later
// (locked, disk full), it goes on in memory with what is known, and everything entered from then on is kept
// in a file beside it, for the next program that can open the ledger. Used by LedgerKeeper; queries go to
// ledger().
class SafeLedger
{
public:
    explicit SafeLedger(const DatabasePlace &place);

    const DatabasePlace &place() const { return m_place; }

    // Null if Qt's driver for SQLite is missing: then nothing is entered.
    const Ledger *ledger() const { return m_ledger ? &*m_ledger : nullptr; }

    // What has to be reported about the file, without its time: damaged and put aside, or not usable. `told`
    // is called with each later problem, in the middle of the call that found it.
    const std::optional<Message> &problem() const { return m_problem; }
    void onProblem(std::function<void()> told) { m_told = std::move(told); }
    // Something was entered that is not in the file.
    bool hasUncounted() const { return m_hasUncounted; }

    // As in Ledger. Empty: none is kept.
    std::optional<qint64> begin(const Ledger::Entry &entry);
    void count(qint64 id, int writes);
    void plan(qint64 id, int more);
    void settle(qint64 id, const ParameterValues &written, const std::vector<Ledger::Value> &readBefore = {},
                int perhaps = 0);
    void attribute(const std::vector<qint64> &ids, const EncoderIdentity &identity);
    // What was counted by the places of a project that is now in file `to`: from none it moves, from another
    // one it is copied.
    void carryPlaces(const QString &from, const QString &to, BusId bus,
                     const std::vector<qint64> &without = {});

private:
    template <typename What>
    auto safely(What what);
    void open();
    void goOnInMemory(const DatabaseError &why);
    void remember(qint64 id);
    void keepBeside(const Ledger::Record &record);
    void tell(MessageCode id, std::vector<RefusalArgument> arguments);

    DatabasePlace m_place;
    std::optional<Ledger> m_ledger;
    bool m_isInMemory = false;                 // instead of in its file
    std::unique_ptr<WaitingEntries> m_waiting; // null: there is no file it belongs to
    std::map<qint64, Ledger::Record> m_begun;  // here, as they are now
    bool m_hasUncounted = false;
    std::optional<Message> m_problem;
    std::function<void()> m_told;
};

} // namespace codewheel
