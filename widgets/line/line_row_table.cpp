// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/line/line_row_table.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHeaderView>

namespace codewheel {
namespace {

constexpr int lineMeaningLetters = 40;
constexpr int shownBytes = 12; // of an answer of 8 digits; of longer ones the tooltip has the rest

} // namespace

LineRowFilter::LineRowFilter(TrafficModel &rows, QObject *parent)
    : QSortFilterProxyModel(parent)
    , m_rows(rows)
{
    setSourceModel(&rows);
}

void LineRowFilter::hidePolls(bool hide)
{
    m_hidesPolls = hide;
    invalidateFilter();
}

bool LineRowFilter::filterAcceptsRow(int row, const QModelIndex &) const
{
    return !m_hidesPolls || !m_rows.rowAt(row).what.isRoutine();
}

LineRowTable::LineRowTable(TrafficModel &rows, const QString &name, QWidget *parent)
    : QTableView(parent)
    , m_rows(rows)
    , m_filter(new LineRowFilter(rows, this))
{
    setModel(m_filter);
    setAccessibleName(name);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setShowGrid(false);
    setWordWrap(false);
    setIconSize({grid::smallIcon, grid::smallIcon});
    setMinimumHeight(2 * grid::largeIcon);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setStretchLastSection(true);
    setColumnWidths();
}

LineRowTable::~LineRowTable()
{
    setModel(nullptr);
}

void LineRowTable::showColumn(TrafficColumn column, bool show)
{
    setColumnHidden(m_rows.columnOf(column), !show);
}

void LineRowTable::setColumnWidths()
{
    const QFontMetrics numbers(numberFont());
    const QFontMetrics texts(font());
    const int gap = 2 * grid::margin;
    int word = 0;
    for (const auto kind :
         {TrafficKind::sent, TrafficKind::answer, TrafficKind::echo, TrafficKind::garbage, TrafficKind::late})
        word = std::max(word, texts.horizontalAdvance(tr("%1, typed").arg(rowKindWord(kind))));
    const auto setWidth = [this](TrafficColumn column, int width) {
        setColumnWidth(m_rows.columnOf(column), width);
    };
    setWidth(TrafficColumn::time, numbers.horizontalAdvance(QStringLiteral("00:00:00.000")) + gap);
    setWidth(TrafficColumn::direction, word + grid::smallIcon + gap);
    setWidth(TrafficColumn::text, numbers.horizontalAdvance(QString(shownBytes, u'W')) + gap);
    setWidth(TrafficColumn::meaning, lineMeaningLetters * texts.averageCharWidth());
    setWidth(TrafficColumn::bytes, numbers.horizontalAdvance(QString(qsizetype{3} * shownBytes, u'0')) + gap);
    verticalHeader()->setDefaultSectionSize(std::max({grid::smallIcon, numbers.height(), texts.height()}) +
                                            grid::unit);
}

void LineRowTable::copy() const
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

QString LineRowTable::exportText() const
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

void LineRowTable::changeEvent(QEvent *event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        setColumnWidths();
}

} // namespace codewheel
