// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/ledger_rows.h"

#include "journal/ledger_json.h"

#include <QJsonDocument>
#include <QSqlQuery>
#include <QVariant>

namespace codewheel {
namespace {

// After the columns of the entry.
enum LedgerColumn : int { computerColumn = 11, userColumn, originColumn };

Ledger::Entry entryOf(const QSqlQuery &row)
{
    Ledger::Entry entry{.id = row.value(0).toLongLong(),
                        .at = QDateTime::fromMSecsSinceEpoch(row.value(1).toLongLong(), Qt::UTC),
                        .identity = row.value(2).toString(),
                        .by = countedByFromKey(row.value(3).toString()).value_or(CountedBy::place),
                        .place = Place::parse(row.value(4).toString()).value_or(Place()),
                        .device = row.value(5).toString(),
                        .planned = row.value(6).toInt(),
                        .writes = row.value(7).toInt(),
                        .settled = row.value(8).toBool(),
                        .before = ledgerValues(row.value(9)),
                        .writer = {row.value(computerColumn).toString(), row.value(userColumn).toString()}};
    for (const Ledger::Value &value : ledgerValues(row.value(10)))
        entry.written.push_back({value.parameter, value.value});
    return entry;
}

} // namespace

std::vector<Ledger::Value> ledgerValues(const QVariant &column)
{
    return ledgerValues(QJsonDocument::fromJson(column.toString().toUtf8()).array());
}

QString ledgerQuery(const QString &condition)
{
    return QStringLiteral("SELECT entry.%1, computer, user, ifnull(origin.id, entry.id || '-' || at) FROM "
                          "entry LEFT JOIN origin ON origin.entry = entry.id LEFT JOIN writer ON "
                          "writer.entry = entry.id WHERE %2 ORDER BY entry.id")
        .arg(ledgerColumns, condition);
}

Ledger::Record ledgerRecordOf(const QSqlQuery &row)
{
    return {row.value(originColumn).toString(), entryOf(row)};
}

} // namespace codewheel
