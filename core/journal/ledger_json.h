// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/ledger.h"

#include <QJsonArray>

namespace codewheel {

// What the columns of an entry hold (docs/journal.md). What another version, or somebody else, wrote is left
// out when it is read.
QJsonArray valuesToJson(const std::vector<Ledger::Value> &values);
QJsonArray valuesToJson(const ParameterValues &values);
std::vector<Ledger::Value> ledgerValues(const QJsonArray &json);
QString countedByKey(CountedBy by); // "serial-number", "label", "place"
std::optional<CountedBy> countedByFromKey(const QString &key);

// Entries as carried from one ledger to another: `ledger export`, and the file beside a ledger that could not
// be written. The reason for an error is a sentence in the user's language.
QByteArray recordsToJson(const std::vector<Ledger::Record> &records, bool inOneLine);
tl::expected<std::vector<Ledger::Record>, QString> recordsFromJson(const QByteArray &json);

} // namespace codewheel
