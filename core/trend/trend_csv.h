// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "trend/csv_style.h"
#include "trend/row_merge.h"

class QIODevice;

namespace codewheel {

// Writes a part of a trend as a table of comma-separated values (docs/trend-files.md), piece by piece, so
// that a window stays responsive and a large table needs no memory. The device reports errors
// (QIODevice::errorString). Used by window and command line.
class TrendCsv
{
public:
    TrendCsv(QIODevice &device, const TrendExtract &extract, HistoryOf historyOf, const CsvStyle &style = {});

    // Writes the next rows, in some milliseconds. False: all is written, or it cannot be written.
    bool writeSome();
    double part() const { return m_rows.part(); } // that is done, 0..1
    qint64 rows() const { return m_count; }       // written so far, without that of the titles

private:
    // While a value stands, so does its text.
    struct Cell
    {
        struct Until
        {
            Instant until;
            CsvNumbers numbers;
        };

        explicit Cell(const TrendColumn &column);
        void show(Instant at, const std::optional<std::int64_t> &sample, const std::string &decimalSign);

        Track track;
        std::vector<Until> scales; // oldest first
        std::size_t scale = 0;
        std::optional<std::int64_t> value{};
        std::string text{};
    };

    void appendTitles(const TrendExtract &extract);
    void appendRow(Instant at, RowMerge::Cells cells);
    bool put();

    QIODevice &m_device;
    const CsvStyle m_style;
    const Instant m_shift; // its times are told without it
    RowMerge m_rows;
    CsvTimes m_times{m_style};
    std::vector<Cell> m_cells;
    std::string m_text; // not yet written
    qint64 m_count = 0;
};

} // namespace codewheel
