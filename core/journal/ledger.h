// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/database.h"
#include "journal/ledger_writer.h"
#include "vocabulary/eeprom_count.h"
#include "vocabulary/known.h"
#include "vocabulary/place.h"

#include <vector>

namespace codewheel {

// Which encoder was written to, as precisely as known: by its serial number, otherwise by its place in a
// project.
struct EncoderIdentity
{
    CountedBy by = CountedBy::place;
    QString vendor;       // serial numbers are a make's own; empty: not known
    QString serialNumber; // if known by it, read or typed: the same number is the same encoder
    QString project;      // ledgerProject(), for a place; empty: none
    Place place;

    QString key() const; // as stored in the ledger (docs/journal.md)
};

// The file of a project as it is entered: links are resolved, so that a link counts as its file. Empty: none.
QString ledgerProject(const QString &file);

// The account of what this program wrote to the EEPROMs of encoders (docs/journal.md): a database of the
// user, or in memory for the training bus. Everything is on disk when a call returns. Used by LedgerKeeper,
// the restoring of values and the report.
class Ledger
{
public:
    struct Value
    {
        Parameter parameter = Parameter::steps;
        codewheel::Value value = 0;
        Evidence evidence = Evidence::told;
        QDateTime at; // when this was known, UTC

        friend bool operator==(const Value &, const Value &) = default;
    };
    // One job, or words sent by hand.
    struct Entry
    {
        qint64 id = 0;
        QDateTime at; // UTC
        QString identity{};
        CountedBy by = CountedBy::place;
        Place place{};
        QString device{};     // key of its description
        int planned = 0;      // writes, at most
        int writes = 0;       // seen
        bool settled = false; // its end was seen: there were no more
        std::vector<Value> before{};
        ParameterValues written{}; // by hand: what was sent
        LedgerWriter writer{};

        bool isWithoutWrite() const { return settled && writes <= 0; }
        int perhaps() const { return settled ? 0 : std::max(planned - writes, 0); }

        friend bool operator==(const Entry &, const Entry &) = default;
    };
    // An entry as other ledgers may have it too: on another computer, or in the file beside this one.
    struct Record
    {
        QString origin; // identifies it for ever, whatever its id is here
        Entry entry{};
    };
    struct Account
    {
        QString identity;
        Place place; // where it was last
        QString device;
        EepromCount count;
    };

    // Takes in what waits in files beside it (WaitingEntries).
    static Stored<Ledger> open(const DatabasePlace &place);

    // Before a job sends its first word, and for words by hand, by ledgerWriter(). Returns the id.
    Stored<qint64> begin(const Entry &entry);
    Stored<void> count(qint64 id, int writes);
    // It may write more than was planned.
    Stored<void> plan(qint64 id, int more);
    // The job has ended, and read these values before it wrote. An entry under which nothing was written is
    // no longer counted or listed, and stays for other ledgers that have it as begun. `perhaps`: so many
    // writes more may have been made, so it is not settled.
    Stored<void> settle(qint64 id, const ParameterValues &written, const std::vector<Value> &readBefore = {},
                        int perhaps = 0);
    // It has become known which encoder that was.
    Stored<void> attribute(const std::vector<qint64> &ids, const EncoderIdentity &identity);

    // The places of a project apply to its copy in another file too: what was counted by them is noted for
    // both, each entry once. `from`: not empty. `without`: entries that are left out.
    Stored<void> copyPlaces(const QString &from, const QString &to, BusId bus,
                            const std::vector<qint64> &without);

    // What was counted by the places of projects without a file belongs to the first file that one gets.
    Stored<void> movePlaces(const QString &to, BusId bus);

    // `running`: what is under way, and so is no doubt about the past.
    EepromCount writes(const EncoderIdentity &identity, const std::vector<qint64> &running = {}) const;
    // Null: never written.
    QDateTime since(const EncoderIdentity &identity) const { return writes(identity).since; }
    // With what the encoder had before each, the newest first; those of which nothing is known are left out.
    std::vector<Entry> valuesBefore(const EncoderIdentity &identity) const;
    std::vector<Account> accounts() const; // by identity

    // By id, also those without a write.
    Stored<std::vector<Record>> records() const;
    std::optional<Record> record(qint64 id) const;
    // Takes in another ledger: an entry that is already known is not duplicated, but completed with what is
    // known of it there. One settled without a write is added nowhere, and no longer counted where it is
    // known. All or, with an error, nothing.
    struct Merged
    {
        int added = 0;
        int known = 0;
    };
    Stored<Merged> merge(const std::vector<Record> &records);
    // As they are, ids included.
    Stored<void> copy(const std::vector<Record> &records);

private:
    explicit Ledger(Database database)
        : m_database(std::move(database))
    {}
    Stored<void> merge(Record there, Merged &merged);
    void takeOver(const QStringList &left);
    Stored<qint64> insert(const Record &record);

    Database m_database;
};

} // namespace codewheel
