// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/fitted_columns.h"

#include "widgets/look/heading_width.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/on_event.h"
#include "widgets/look/wrapped_cells.h"

#include <QHeaderView>
#include <QTableView>

#include <algorithm>
#include <utility>
#include <vector>

namespace codewheel {
namespace {

using Widths = WrappedCells::Widths;

constexpr int mostRows = 1'000; // that are measured
constexpr int leastElided = 10; // characters of a text that may be elided

// Of columns none of which is wider than `level`, unless a word needs it.
int widthAt(const Widths &column, int level)
{
    return std::clamp(level, column.word, column.line);
}

int widthAt(const std::vector<Widths> &columns, int level)
{
    int width = 0;
    for (const Widths &column : columns)
        width += widthAt(column, level);
    return width;
}

int highestLevel(const std::vector<Widths> &columns, int room)
{
    int level = 0;
    for (int beyond = room + 1; beyond - level > 1;) {
        const int middle = (level + beyond) / 2;
        (widthAt(columns, middle) <= room ? level : beyond) = middle;
    }
    return level;
}

// Where the longest words have no room beside each other, their cells are in small type. If that does not
// help either, the widest give way: without a scroll bar the last ones would be out of sight.
void giveWay(std::vector<Widths> &columns, int room)
{
    if (widthAt(columns, 0) <= room)
        return;
    std::vector<Widths> words = columns;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        columns[i].word = columns[i].smallWord;
        words[i] = {0, columns[i].smallWord, 0};
    }
    const int level = highestLevel(words, room);
    for (Widths &column : columns)
        column.word = std::min(column.word, level);
}

std::vector<Widths> widthsOf(const QTableView &table, const WrappedCells &cells)
{
    std::vector<Widths> columns;
    for (int column = 0; column < table.model()->columnCount(); ++column) {
        if (table.isColumnHidden(column)) {
            columns.push_back({});
            continue;
        }
        const QHeaderView &header = *table.horizontalHeader(); // makes no column narrower than its least
        const int head = std::max(headingWidth(header, column), header.minimumSectionSize());
        Widths widest{head, head, head};
        for (int row = 0; row < std::min(table.model()->rowCount(), mostRows); ++row) {
            if (table.columnSpan(row, column) > 1)
                continue;
            const Widths its = cells.widthsOf(table.model()->index(row, column));
            widest = {std::max(widest.word, its.word), std::max(widest.line, its.line),
                      std::max(widest.smallWord, its.smallWord)};
        }
        columns.push_back(widest);
    }
    return columns;
}

} // namespace

FittedColumns::FittedColumns(QTableView &table, int stretched)
    : QObject(&table)
    , m_table(table)
    , m_stretched(stretched)
    , m_cells(new WrappedCells(table))
{}

void FittedColumns::useIn(QTableView &table, int stretched)
{
    (new FittedColumns(table, stretched))->follow();
}

void FittedColumns::follow()
{
    m_table.setItemDelegate(m_cells);
    m_table.horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    connect(m_table.horizontalHeader(), &QHeaderView::sectionResized, this, [this](int, int before, int now) {
        if (before == 0 || now == 0) // hidden, or shown again
            fitSoon();
    });
    onEventOf(&m_table, {QEvent::StyleChange, QEvent::FontChange}, this, [this] { fitSoon(); });
    onEventOf(m_table.viewport(), {QEvent::Resize}, this, [this] { fitSoon(); });
    const QAbstractItemModel *model = m_table.model();
    for (const auto changed : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(model, changed, this, &FittedColumns::fitSoon);
    connect(model, &QAbstractItemModel::modelReset, this, &FittedColumns::fitSoon);
    connect(model, &QAbstractItemModel::dataChanged, this, &FittedColumns::fitSoon);
}

// Once for all rows that change, and before they are painted.
void FittedColumns::fitSoon()
{
    if (!std::exchange(m_isDue, true))
        QMetaObject::invokeMethod(this, &FittedColumns::fit, Qt::QueuedConnection);
}

void FittedColumns::fit()
{
    m_isDue = false;
    std::vector<Widths> columns = widthsOf(m_table, *m_cells);
    if (mayElide(m_table, m_stretched)) {
        const int least = std::min(columns[static_cast<std::size_t>(m_stretched)].line,
                                   leastElided * m_table.fontMetrics().averageCharWidth());
        columns[static_cast<std::size_t>(m_stretched)] = {least, least, least};
    }
    const int room = m_table.viewport()->width();
    if (m_table.horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff)
        giveWay(columns, room);
    const int level = highestLevel(columns, room);
    const int left = std::max(room - widthAt(columns, level), 0);
    for (int column = 0; column < static_cast<int>(columns.size()); ++column)
        if (!m_table.isColumnHidden(column))
            m_table.setColumnWidth(column, widthAt(columns[static_cast<std::size_t>(column)], level) +
                                               (column == m_stretched ? left : 0));
    m_table.resizeRowsToContents();
}

} // namespace codewheel
