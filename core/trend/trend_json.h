// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "trend/csv_style.h"
#include "trend/trend_extract.h"
#include "trend/trend_origin.h"

namespace codewheel {

// The table that is described.
struct TrendTable
{
    QString fileName; // without its folder
    TrendExtract extract;
    CsvStyle style;
    qint64 rows = 0;
};

// What the table itself does not tell (docs/trend-files.md).
QByteArray trendJson(const TrendTable &table, const HistoryOf &historyOf, const TrendOrigin &origin);

// Whether the text is one of these, of whatever version.
bool isTrendJson(const QByteArray &text);

} // namespace codewheel
