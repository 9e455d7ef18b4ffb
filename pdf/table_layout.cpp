// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf/table_layout.h"

#include "pdf/column_widths.h"
#include "pdf/sheet_format.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr qreal padding = sheet::mm(0.7); // above and below the lines of a row

std::vector<qreal> wantedWidths(const ReportTable &table, const ReportFonts &fonts)
{
    std::vector<qreal> widths;
    for (qsizetype column = 0; column < table.header.size(); ++column) {
        qreal widest = 0;
        for (const QString &word : table.header[column].split(u' '))
            widest = std::max(widest, textWidth(word, fonts.stressedCell));
        for (const ReportTable::Row &row : table.rows)
            widest = std::max(widest, textWidth(row.cells[column], fonts.stressedCell));
        widths.push_back(widest + sheet::columnGap);
    }
    return widths;
}

} // namespace

TableLayout::TableLayout(SheetFlow &flow, const ReportTable &table)
    : m_flow(flow)
    , m_table(table)
    , m_widths(columnWidths(wantedWidths(table, flow.fonts()), sheet::body.width() + sheet::columnGap))
    , m_header(broken(table.header, true, false))
{}

void TableLayout::add()
{
    const qsizetype linesOfFirst =
        m_table.rows.empty() ? 0
                             : broken(m_table.rows.front().cells, false, m_table.rows.front().stressed).lines;
    m_flow.need(heightOf(m_header.lines) + heightOf(linesOfFirst));
    addHeader();
    for (const ReportTable::Row &row : m_table.rows)
        addRow(broken(row.cells, false, row.stressed));
    m_flow.skip(sheet::gap);
}

const QFont &TableLayout::fontOf(std::size_t column, bool isHeader, bool stressed) const
{
    const ReportFonts &fonts = m_flow.fonts();
    if (isHeader || stressed)
        return fonts.stressedCell;
    return m_table.columns[column] == ReportTable::Column::code ? fonts.codeCell : fonts.cell;
}

TableLayout::Row TableLayout::broken(const QStringList &cells, bool isHeader, bool stressed) const
{
    Row row;
    for (std::size_t column = 0; column < m_widths.size(); ++column) {
        const QFont &font = fontOf(column, isHeader, stressed);
        row.cells.push_back(textLines(cells.value(static_cast<qsizetype>(column)), font,
                                      m_widths[column] - sheet::columnGap));
        row.fonts.push_back(font);
        row.lines = std::max(row.lines, row.cells.back().size());
    }
    return row;
}

qreal TableLayout::heightOf(qsizetype lines) const
{
    return static_cast<qreal>(lines) * lineHeight(m_flow.fonts().cell) + 2 * padding;
}

void TableLayout::addHeader()
{
    addLines(m_header, 0, m_header.lines);
    m_flow.addThickRule();
}

void TableLayout::addRow(const Row &row)
{
    const qreal freshRoom = sheet::body.height() - heightOf(m_header.lines);
    qsizetype first = 0;
    while (first < row.lines) {
        qsizetype count = row.lines - first;
        const bool fitsOneSheet = heightOf(count) <= freshRoom;
        if (heightOf(count) > m_flow.room() && (fitsOneSheet || m_flow.room() < heightOf(2))) {
            m_flow.nextSheet();
            addHeader();
        }
        while (heightOf(count) > m_flow.room() && count > 1)
            --count;
        addLines(row, first, count);
        m_flow.addFaintRule();
        first += count;
    }
}

void TableLayout::addLines(const Row &row, qsizetype first, qsizetype count)
{
    const qreal step = lineHeight(m_flow.fonts().cell);
    m_flow.skip(padding);
    for (qsizetype line = first; line < first + count; ++line) {
        qreal left = sheet::body.left();
        for (std::size_t column = 0; column < m_widths.size(); ++column) {
            const auto align = m_table.columns[column] == ReportTable::Column::number
                                   ? SheetFlow::Align::right
                                   : SheetFlow::Align::left;
            m_flow.addText(row.cells[column].value(line), row.fonts[column], left,
                           m_widths[column] - sheet::columnGap, align);
            left += m_widths[column];
        }
        m_flow.skip(step);
    }
    m_flow.skip(padding);
}

} // namespace codewheel
