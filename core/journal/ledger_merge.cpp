// SPDX-License-Identifier: GPL-3.0-or-later
// Entries that come from another ledger, or go to one.
#include "journal/ledger.h"
#include "journal/ledger_rows.h"

#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

#include <algorithm>

namespace codewheel {
namespace {

// How certain it is which encoder it was.
int certainty(CountedBy by)
{
    return by == CountedBy::serialNumber ? 2 : by == CountedBy::labelSerialNumber ? 1 : 0;
}

// Everything that either of them knows.
Ledger::Record combined(Ledger::Record here, const Ledger::Record &there)
{
    Ledger::Entry &entry = here.entry;
    if (certainty(there.entry.by) > certainty(entry.by)) {
        entry.by = there.entry.by;
        entry.identity = there.entry.identity;
    }
    entry.planned = std::max(entry.planned, there.entry.planned);
    entry.writes = std::max(entry.writes, there.entry.writes);
    if (there.entry.settled && !entry.settled) {
        entry.settled = true;
        entry.written = there.entry.written;
    }
    if (there.entry.before.size() > entry.before.size())
        entry.before = there.entry.before;
    if (entry.writer == LedgerWriter())
        entry.writer = there.entry.writer;
    return here;
}

} // namespace

Stored<std::vector<Ledger::Record>> Ledger::records() const
{
    QSqlQuery query = m_database.query(ledgerQuery(QStringLiteral("true")));
    if (auto done = m_database.run(query); !done)
        return tl::unexpected(done.error());
    std::vector<Record> records;
    while (query.next())
        records.push_back(ledgerRecordOf(query));
    if (query.lastError().isValid()) // in the middle of the file
        return tl::unexpected(Database::errorOf(query.lastError()));
    return records;
}

std::optional<Ledger::Record> Ledger::record(qint64 id) const
{
    QSqlQuery query = m_database.query(ledgerQuery(QStringLiteral("entry.id = ?")));
    query.addBindValue(id);
    return m_database.run(query) && query.next() ? std::optional(ledgerRecordOf(query)) : std::nullopt;
}

Stored<Ledger::Merged> Ledger::merge(const std::vector<Record> &records)
{
    Merged merged;
    return m_database
        .inTransaction([&]() -> Stored<void> {
            for (const Record &record : records)
                if (auto done = merge(record, merged); !done)
                    return done;
            return {};
        })
        .map([&] { return merged; });
}

Stored<void> Ledger::merge(Record there, Merged &merged)
{
    QSqlQuery query = m_database.query(ledgerQuery(QStringLiteral("origin.id = ?")));
    query.addBindValue(there.origin);
    if (auto done = m_database.run(query); !done)
        return done;
    const bool isKnown = query.next();
    if (!isKnown && there.entry.isWithoutWrite())
        return {};
    there.entry.id = 0;
    const Record before = isKnown ? ledgerRecordOf(query) : there;
    query.finish();
    const Record now = combined(before, there);
    if (!before.entry.isWithoutWrite())
        ++(isKnown ? merged.known : merged.added);
    return insert(now).map([](qint64) {});
}

Stored<void> Ledger::copy(const std::vector<Record> &records)
{
    return m_database.inTransaction([&]() -> Stored<void> {
        for (const Record &record : records)
            if (auto inserted = insert(record); !inserted)
                return tl::unexpected(inserted.error());
        return {};
    });
}

} // namespace codewheel
