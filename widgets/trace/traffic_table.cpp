// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trace/traffic_table.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icon_cells.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/on_event.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>

namespace codewheel {
namespace {

constexpr int fewestMeaningLetters = 20; // of the meaning
constexpr int wantedMeaningLetters = 28;
constexpr int fewestBytes = 4;
constexpr int shownBytes = 12; // of an answer of 8 digits; of longer ones the tooltip has the rest

} // namespace

TrafficFilter::TrafficFilter(TrafficModel &rows, QObject *parent)
    : QSortFilterProxyModel(parent)
    , m_rows(rows)
{
    setSourceModel(&rows);
}

void TrafficFilter::hideAutomatic(bool hide)
{
    m_hidesAutomatic = hide;
    invalidateFilter();
}

void TrafficFilter::setWanted(std::function<bool(const TrafficRow &)> isWanted)
{
    m_isWanted = std::move(isWanted);
    invalidateFilter();
}

bool TrafficFilter::filterAcceptsRow(int row, const QModelIndex &) const
{
    const TrafficRow &what = m_rows.rowAt(row).what;
    return (!m_hidesAutomatic || !what.isRoutine()) && (!m_isWanted || m_isWanted(what));
}

TrafficTable::TrafficTable(TrafficModel &rows, const QString &name, QWidget *parent)
    : LogTable(name, parent)
    , m_rows(rows)
    , m_filter(new TrafficFilter(rows, this))
{
    setModel(m_filter);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setItemDelegateForColumn(rows.columnOf(TrafficColumn::direction), new IconCells(this));
    for (const auto column : {TrafficColumn::text, TrafficColumn::bytes})
        if (has(column))
            allowEliding(*this, rows.columnOf(column));
    setColumnWidths();
    onEvent(this, {QEvent::FontChange, QEvent::StyleChange}, [this] { setColumnWidths(); });
}

TrafficTable::~TrafficTable()
{
    const QSignalBlocker silent(this); // receivers may be gone by now
    setModel(nullptr);
}

bool TrafficTable::has(TrafficColumn column) const
{
    return m_rows.columnOf(column) < m_rows.columnCount();
}

void TrafficTable::showColumn(TrafficColumn column, bool show)
{
    setColumnHidden(m_rows.columnOf(column), !show);
    updateGeometries();
}

std::optional<Place> TrafficTable::chosenPlace() const
{
    const QModelIndex chosen = m_filter->mapToSource(currentIndex());
    return chosen.isValid() ? m_rows.rowAt(chosen.row()).what.place : std::nullopt;
}

void TrafficTable::setColumnWidths()
{
    const QFontMetrics numbers(numberFont());
    const int gap = 2 * grid::margin;
    const auto setWidth = [this](TrafficColumn column, int width) {
        if (has(column))
            setColumnWidth(m_rows.columnOf(column), width);
    };
    setWidth(TrafficColumn::time, numbers.horizontalAdvance(QStringLiteral("00:00:00.000")) + gap);
    setWidth(TrafficColumn::direction, grid::smallIcon + gap);
    setWidth(TrafficColumn::text, numbers.horizontalAdvance(QString(shownBytes, u'W')) + gap);
    setWidth(TrafficColumn::identifier, numbers.horizontalAdvance(QStringLiteral("0CFFE0E0")) + gap);
    setWidth(TrafficColumn::who, fontMetrics().horizontalAdvance(QStringLiteral("can:127")) + gap);
    setTextColumn(m_rows.columnOf(TrafficColumn::meaning), fewestMeaningLetters);
    const auto widthOf = [&](int bytes) {
        return numbers.horizontalAdvance(QString(qsizetype{3} * bytes, u'0')) + gap;
    };
    setElasticColumn({.column = m_rows.columnOf(TrafficColumn::bytes),
                      .least = widthOf(fewestBytes),
                      .most = widthOf(shownBytes),
                      .wantedLetters = wantedMeaningLetters});
}

void TrafficTable::copy() const
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

QString TrafficTable::exportText() const
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

} // namespace codewheel
