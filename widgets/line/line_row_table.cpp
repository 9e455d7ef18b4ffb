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

LineRowTable::LineRowTable(LineRowModel &rows, const QString &name, QWidget *parent)
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

void LineRowTable::showColumn(LineRowModel::Column column, bool show)
{
    setColumnHidden(column, !show);
}

void LineRowTable::setColumnWidths()
{
    const QFontMetrics numbers(numberFont());
    const QFontMetrics texts(font());
    const int gap = 2 * grid::margin;
    int word = 0;
    for (const auto kind : {esc::LineRow::Kind::sent, esc::LineRow::Kind::answer, esc::LineRow::Kind::echo,
                            esc::LineRow::Kind::garbage, esc::LineRow::Kind::late})
        word = std::max(word, texts.horizontalAdvance(tr("%1, typed").arg(rowKindWord(kind))));
    setColumnWidth(LineRowModel::time, numbers.horizontalAdvance(QStringLiteral("00:00:00.000")) + gap);
    setColumnWidth(LineRowModel::kind, word + grid::smallIcon + gap);
    setColumnWidth(LineRowModel::text, numbers.horizontalAdvance(QString(shownBytes, u'W')) + gap);
    setColumnWidth(LineRowModel::meaning, lineMeaningLetters * texts.averageCharWidth());
    setColumnWidth(LineRowModel::bytes,
                   numbers.horizontalAdvance(QString(qsizetype{3} * shownBytes, u'0')) + gap);
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
        const ShownLineRow &shown = m_rows.rowAt(m_filter->mapToSource(m_filter->index(row, 0)).row());
        QStringList cells{m_rows.dateTimeText(shown)};
        for (int column = LineRowModel::kind; column <= LineRowModel::bytes; ++column)
            cells << m_rows.cellText(shown, column, ControlCharacters::pictures);
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
