// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/file_replacement.h"
#include "trend/trend_csv.h"
#include "trend/trend_json.h"

namespace codewheel {

// Exports a part of a trend: the table as a file, and beside it a JSON file that says what the table itself
// does not tell. Neither is there before both are complete: what was there stays until then, and for good if
// anything goes wrong. Used by window and command line; to cancel, destroy it.
class TrendFiles
{
public:
    TrendFiles(const QString &path, const TrendExtract &extract, HistoryOf historyOf, const CsvStyle &style);

    // "hoist.json" beside "hoist.csv", "hoist.txt.json" beside "hoist.txt".
    static QString descriptionPath(const QString &path);

    // Refused: fileNotWritten, of either file. A file that is there in place of the description is replaced
    // only if it is the description of a trend.
    Result<void> begin();
    // As TrendCsv::writeSome(). A failure is reported by finish().
    bool writeSome() { return m_csv.writeSome(); }
    double part() const { return m_csv.part(); }
    qint64 rows() const { return m_csv.rows(); }
    // First the description is put in its place, then the table, so that no table lacks its description.
    Result<void> finish(const TrendOrigin &origin);

    QString path() const { return m_file.path(); }

private:
    TrendExtract m_extract;
    HistoryOf m_historyOf;
    CsvStyle m_style;
    FileReplacement m_file;
    TrendCsv m_csv;
};

} // namespace codewheel
