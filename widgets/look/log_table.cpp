// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/log_table.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/on_event.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QScrollBar>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int mostLines = 4; // of a text in its row; tooltip and details show longer ones in full
constexpr int rounds = 5;    // rows that grow push others out of sight

} // namespace

LogTable::LogTable(const QString &name, QWidget *parent)
    : QTableView(parent)
{
    setAccessibleName(name);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setTabKeyNavigation(false);
    setShowGrid(false);
    setWordWrap(true);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setIconSize({grid::smallIcon, grid::smallIcon});
    setMinimumHeight(2 * grid::largeIcon);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setHighlightSections(false);
    setLineHeight();
    connect(horizontalHeader(), &QHeaderView::sectionResized, this,
            [this](int column, int before, int width) {
                if (before > 0 && width > 0) // else it is hidden, or shown again
                    keepDragged(column, width);
            });
    // Whoever scrolls up wants to read; at the end one follows again.
    QScrollBar *bar = verticalScrollBar();
    connect(bar, &QScrollBar::actionTriggered, this, [this, bar] {
        if (m_follow != nullptr)
            m_follow->setChecked(bar->sliderPosition() >= bar->maximum());
    });
    onEvent(this, {QEvent::FontChange, QEvent::StyleChange}, [this] { setLineHeight(); });
}

void LogTable::setTextColumn(int column, int fewestLetters)
{
    m_textColumn = column;
    m_fewestLetters = fewestLetters;
    if (!mayElide(*this, column))
        allowEliding(*this, column);
    updateGeometries();
}

void LogTable::setElasticColumn(const Elastic &elastic)
{
    m_elastic = elastic;
    updateGeometries();
}

void LogTable::setFollow(QAction &follow)
{
    m_follow = &follow;
    connect(&follow, &QAction::toggled, this, &LogTable::updateGeometries);
}

void LogTable::setHeadings(std::function<bool(int)> isHeading)
{
    m_isHeading = std::move(isHeading);
}

void LogTable::setModel(QAbstractItemModel *model)
{
    m_shift = 0;
    clearSpans();
    const QItemSelectionModel *before = selectionModel();
    QTableView::setModel(model);
    if (selectionModel() != before) // it is the same one if the model is
        delete before;
}

void LogTable::reset()
{
    m_shift = 0;
    clearSpans();
    QTableView::reset();
}

bool LogTable::isFollowing() const
{
    return m_follow != nullptr && m_follow->isChecked();
}

void LogTable::rowsInserted(const QModelIndex &parent, int first, int last)
{
    QTableView::rowsInserted(parent, first, last);
    const int line = verticalHeader()->defaultSectionSize();
    const bool isAtEnd = last + 1 == model()->rowCount();
    if (isFollowing())
        shiftBy(0);
    else if (!isAtEnd && verticalHeader()->sectionPosition(first) <= verticalHeader()->offset() + line)
        shiftBy((last + 1 - first) * line);
}

void LogTable::rowsAboutToBeRemoved(const QModelIndex &parent, int first, int last)
{
    if (!isFollowing() && verticalHeader()->sectionPosition(first) < verticalHeader()->offset())
        m_shift -= verticalHeader()->sectionPosition(last) + verticalHeader()->sectionSize(last) -
                   verticalHeader()->sectionPosition(first);
    QTableView::rowsAboutToBeRemoved(parent, first, last);
}

void LogTable::shiftBy(int pixels)
{
    m_shift += pixels;
    executeDelayedItemsLayout();
    updateGeometries();
}

void LogTable::updateGeometries()
{
    if (m_isFitting) {
        QTableView::updateGeometries();
        return;
    }
    const QScopedValueRollback fitting(m_isFitting, true);
    QScrollBar *bar = verticalScrollBar();
    for (int round = 0; round < rounds; ++round) {
        fitTextColumn();
        QTableView::updateGeometries();
        if (const int shift = std::exchange(m_shift, 0); shift != 0)
            bar->setValue(bar->value() + shift);
        if (isFollowing())
            bar->setValue(bar->maximum());
        if (!fitRows())
            break;
    }
}

void LogTable::scrollContentsBy(int dx, int dy)
{
    QTableView::scrollContentsBy(dx, dy);
    if (dy != 0 && !m_isFitting)
        updateGeometries();
}

int LogTable::widthOf(int column) const
{
    return isColumnHidden(column) ? 0 : columnWidth(column);
}

void LogTable::fitTextColumn()
{
    if (m_textColumn < 0 || model() == nullptr)
        return;
    const int letter = fontMetrics().averageCharWidth();
    int width = viewport()->width();
    for (int column = 0; column < model()->columnCount(); ++column)
        if (column != m_textColumn && column != m_elastic.column)
            width -= widthOf(column);
    if (m_elastic.column >= 0 && !isColumnHidden(m_elastic.column)) {
        const int left = width - m_elastic.wantedLetters * letter;
        const int elastic = std::clamp(left, m_elastic.least, m_elastic.most);
        if (columnWidth(m_elastic.column) != elastic)
            setColumnWidth(m_elastic.column, elastic);
        width -= elastic;
    }
    width = std::max(width, m_fewestLetters * letter);
    if (columnWidth(m_textColumn) != width)
        setColumnWidth(m_textColumn, width);
}

void LogTable::keepDragged(int column, int width)
{
    if (column == m_elastic.column && !m_isFitting)
        m_elastic.least = m_elastic.most = width;
}

bool LogTable::fitRows()
{
    if (model() == nullptr)
        return false;
    bool isOther = false;
    // While the model changes, the header has the rows of the new one, and the table still those of the old.
    const int count = std::min(model()->rowCount(), verticalHeader()->count());
    for (int row = std::max(0, rowAt(0)); row < count; ++row) {
        if (rowViewportPosition(row) > viewport()->height())
            break;
        if (m_isHeading && m_isHeading(row) && columnSpan(row, 0) == 1)
            setSpan(row, 0, 1, model()->columnCount());
        const int height = heightOf(row);
        if (height == rowHeight(row))
            continue;
        verticalHeader()->resizeSection(row, height);
        isOther = true;
    }
    return isOther;
}

// Most texts fit in one line, which can be checked quickly.
int LogTable::heightOf(int row) const
{
    const int line = verticalHeader()->defaultSectionSize();
    if (m_textColumn < 0 || columnSpan(row, 0) > 1)
        return line;
    const QString text = model()->index(row, m_textColumn).data().toString();
    const int margins = 4 * grid::unit;
    if (fontMetrics().horizontalAdvance(text) + margins <= columnWidth(m_textColumn))
        return line;
    return std::clamp(sizeHintForRow(row) + grid::unit, line,
                      line + (mostLines - 1) * fontMetrics().lineSpacing());
}

void LogTable::setLineHeight()
{
    verticalHeader()->setDefaultSectionSize(
        std::max({grid::smallIcon, QFontMetrics(numberFont()).height(), fontMetrics().height()}) +
        grid::unit);
}

// Not every keyboard has the platform's key for copying.
void LogTable::keyPressEvent(QKeyEvent *event)
{
    if (event->key() != Qt::Key_F10 || event->modifiers() != Qt::ShiftModifier) {
        QTableView::keyPressEvent(event);
        return;
    }
    const QPoint position = visualRect(currentIndex()).center();
    QContextMenuEvent menu(QContextMenuEvent::Keyboard, position, viewport()->mapToGlobal(position));
    QCoreApplication::sendEvent(viewport(), &menu);
}

// Keyboard navigation starts at the newest row, not at the oldest.
void LogTable::focusInEvent(QFocusEvent *event)
{
    if (isFollowing() && !currentIndex().isValid() && model() != nullptr && model()->rowCount() > 0)
        selectionModel()->setCurrentIndex(model()->index(model()->rowCount() - 1, 0),
                                          QItemSelectionModel::NoUpdate);
    QTableView::focusInEvent(event);
}

void LogTable::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QTableView::currentChanged(current, previous);
    if (m_follow != nullptr && current.isValid() && current.row() != previous.row())
        m_follow->setChecked(current.row() == model()->rowCount() - 1);
    Q_EMIT chosenChanged();
}

void LogTable::selectionChanged(const QItemSelection &selected, const QItemSelection &deselected)
{
    QTableView::selectionChanged(selected, deselected);
    Q_EMIT chosenChanged();
}

} // namespace codewheel
