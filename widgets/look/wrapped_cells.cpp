// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/wrapped_cells.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/wrapped_text.h"

#include <QHeaderView>
#include <QPainter>
#include <QTableView>

#include <algorithm>
#include <utility>

namespace codewheel {

namespace {

QFont smallOf(QFont font)
{
    const QFont small = textFont(TextSize::small);
    if (small.pointSizeF() > 0)
        font.setPointSizeF(std::min(font.pointSizeF(), small.pointSizeF()));
    else
        font.setPixelSize(std::min(font.pixelSize(), small.pixelSize()));
    return font;
}

int longestWordOf(const QString &text, const QFont &font)
{
    const QFontMetrics metrics(font);
    int longest = 0;
    for (const QString &word : withWholeParentheses(text).split(u' '))
        longest = std::max(longest, metrics.horizontalAdvance(word));
    return longest;
}

// Small rather than broken within a word: half a number is misread.
QFont fittingFont(const QString &text, const QFont &usual, int room)
{
    return longestWordOf(text, usual) > room ? smallOf(usual) : usual;
}

} // namespace

WrappedCells::WrappedCells(QTableView &table)
    : QStyledItemDelegate(&table)
    , m_table(table)
{}

void WrappedCells::useIn(QTableView &table)
{
    table.setItemDelegate(new WrappedCells(table));
    connect(table.horizontalHeader(), &QHeaderView::sectionResized, &table,
            &QTableView::resizeRowsToContents);
}

WrappedCells::Widths WrappedCells::widthsOf(const QModelIndex &index) const
{
    QStyleOptionViewItem option;
    option.initFrom(&m_table);
    option.widget = &m_table;
    const int icon = m_table.style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, &m_table);
    option.decorationSize = m_table.iconSize().isValid() ? m_table.iconSize() : QSize(icon, icon);
    initStyleOption(&option, index);
    const int word = longestWordOf(option.text, option.font);
    const int line = std::max(word, QFontMetrics(option.font).horizontalAdvance(option.text));
    const int beside = besideText(option) + grid::unit; // lines are broken to the pixel
    return {word + beside, line + beside, longestWordOf(option.text, smallOf(option.font)) + beside};
}

// All that icon and check box leave.
QRect WrappedCells::textRect(const QStyleOptionViewItem &given) const
{
    QStyleOptionViewItem option = given;
    option.showDecorationSelected = true;
    return m_table.style()
        ->subElementRect(QStyle::SE_ItemViewItemText, &option, &m_table)
        .adjusted(grid::unit, 0, -grid::unit, 0);
}

int WrappedCells::besideText(const QStyleOptionViewItem &given) const
{
    constexpr int wide = 1'000;
    QStyleOptionViewItem option = given;
    option.rect = QRect(0, 0, wide, wide);
    return wide - textRect(option).width();
}

void WrappedCells::paint(QPainter *painter, const QStyleOptionViewItem &given, const QModelIndex &index) const
{
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QRect inside = textRect(option);
    QString text = std::exchange(option.text, {});
    if (mayElide(m_table, index.column()))
        text = option.fontMetrics.elidedText(text, Qt::ElideMiddle, inside.width() - 1);
    m_table.style()->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    painter->save();
    painter->setPen(option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
    WrappedText(text, fittingFont(text, option.font, inside.width()), inside.width(), option.displayAlignment)
        .draw(*painter, inside);
    painter->restore();
}

QSize WrappedCells::sizeHint(const QStyleOptionViewItem &given, const QModelIndex &index) const
{
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    option.features.setFlag(QStyleOptionViewItem::WrapText, false);
    const QSize inOneLine = m_table.style()->sizeFromContents(QStyle::CT_ItemViewItem, &option, {}, &m_table);
    int room = -besideText(option);
    for (int span = 0; span < m_table.columnSpan(index.row(), index.column()); ++span)
        room += m_table.columnWidth(index.column() + span);
    if (mayElide(m_table, index.column()))
        room = QWIDGETSIZE_MAX;
    const QFont font = fittingFont(option.text, option.font, room);
    const int lines = WrappedText(option.text, font, room, option.displayAlignment).height();
    return {inOneLine.width() + grid::unit, std::max(inOneLine.height(), lines + 2 * grid::unit)};
}

} // namespace codewheel
