// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/esc_line_row_table.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icon_cells.h"
#include "widgets/look/may_elide.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHeaderView>

namespace codewheel {
namespace {

constexpr int fewestLetters = 20; // of the meaning
constexpr int wantedLetters = 28;
constexpr int fewestBytes = 4;
constexpr int shownBytes = 12; // of an answer of 8 digits; of longer ones the tooltip has the rest

} // namespace

EscLineRowFilter::EscLineRowFilter(TrafficModel &rows, QObject *parent)
    : QSortFilterProxyModel(parent)
    , m_rows(rows)
{
    setSourceModel(&rows);
}

void EscLineRowFilter::hideAutomatic(bool hide)
{
    m_hidesAutomatic = hide;
    invalidateFilter();
}

bool EscLineRowFilter::filterAcceptsRow(int row, const QModelIndex &) const
{
    return !m_hidesAutomatic || !m_rows.rowAt(row).what.isRoutine();
}

EscLineRowTable::EscLineRowTable(TrafficModel &rows, const QString &name, QWidget *parent)
    : LogTable(name, parent)
    , m_rows(rows)
    , m_filter(new EscLineRowFilter(rows, this))
{
    setModel(m_filter);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setItemDelegateForColumn(rows.columnOf(TrafficColumn::direction), new IconCells(this));
    for (const auto column : {TrafficColumn::text, TrafficColumn::bytes})
        allowEliding(*this, rows.columnOf(column));
    setColumnWidths();
}

EscLineRowTable::~EscLineRowTable()
{
    const QSignalBlocker silent(this); // receivers may be gone by now
    setModel(nullptr);
}

void EscLineRowTable::showColumn(TrafficColumn column, bool show)
{
    setColumnHidden(m_rows.columnOf(column), !show);
    updateGeometries();
}

std::optional<Place> EscLineRowTable::chosenPlace() const
{
    const QModelIndex chosen = m_filter->mapToSource(currentIndex());
    return chosen.isValid() ? m_rows.rowAt(chosen.row()).what.place : std::nullopt;
}

void EscLineRowTable::setColumnWidths()
{
    const QFontMetrics numbers(numberFont());
    const int gap = 2 * grid::margin;
    const auto setWidth = [this](TrafficColumn column, int width) {
        setColumnWidth(m_rows.columnOf(column), width);
    };
    setWidth(TrafficColumn::time, numbers.horizontalAdvance(QStringLiteral("00:00:00.000")) + gap);
    setWidth(TrafficColumn::direction, grid::smallIcon + gap);
    setWidth(TrafficColumn::text, numbers.horizontalAdvance(QString(shownBytes, u'W')) + gap);
    setTextColumn(m_rows.columnOf(TrafficColumn::meaning), fewestLetters);
    const auto widthOf = [&](int bytes) {
        return numbers.horizontalAdvance(QString(qsizetype{3} * bytes, u'0')) + gap;
    };
    setElasticColumn({.column = m_rows.columnOf(TrafficColumn::bytes),
                      .least = widthOf(fewestBytes),
                      .most = widthOf(shownBytes),
                      .wantedLetters = wantedLetters});
}

void EscLineRowTable::copy() const
{
    const bool onlyChosen = selectionModel()->hasSelection();
    QString text;
    for (int row = 0; row < m_filter->rowCount(); ++row) {
        if (onlyChosen && !selectionModel()->isRowSelected(row))
            continue;
        QStringList cells;
        for (int column = 0; column < m_filter->columnCount(); ++column)
            if (!isColumnHidden(column))
                cells << m_filter->index(row, column).data().toString();
        text += cells.join(u'\t') + u'\n';
    }
    QApplication::clipboard()->setText(text);
}

QString EscLineRowTable::exportText() const
{
    QString text;
    for (int row = 0; row < m_filter->rowCount(); ++row) {
        const ShownTraffic &shown = m_rows.rowAt(m_filter->mapToSource(m_filter->index(row, 0)).row());
        QStringList cells{shown.what.time.toString(Qt::ISODateWithMs)};
        for (int column = 1; column < m_rows.columnCount(); ++column)
            cells << m_rows.cellText(shown, m_rows.columnAt(column), ControlCharacters::pictures);
        text += cells.join(u'\t') + u'\n';
    }
    return text;
}

void EscLineRowTable::changeEvent(QEvent *event)
{
    LogTable::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        setColumnWidths();
}

} // namespace codewheel
