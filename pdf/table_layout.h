// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdf/sheet_flow.h"
#include "report/report.h"

namespace codewheel {

// Lays a table out over as many sheets as it needs, with its header on each. A row is broken only where it is
// higher than a sheet.
class TableLayout
{
public:
    TableLayout(SheetFlow &flow, const ReportTable &table);
    void add();

private:
    struct Row
    {
        std::vector<QStringList> cells; // in lines
        std::vector<QFont> fonts;
        qsizetype lines = 1;
    };

    Row broken(const QStringList &cells, bool isHeader, bool stressed) const;
    const QFont &fontOf(std::size_t column, bool isHeader, bool stressed) const;
    qreal heightOf(qsizetype lines) const;
    void addHeader();
    void addRow(const Row &row);
    void addLines(const Row &row, qsizetype first, qsizetype count);

    SheetFlow &m_flow;
    const ReportTable &m_table;
    std::vector<qreal> m_widths;
    Row m_header;
};

} // namespace codewheel
