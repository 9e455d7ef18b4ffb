// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_delegate.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/structure/structure_columns.h"
#include "widgets/structure/structure_model.h"

#include <QApplication>
#include <QPainter>

namespace codewheel {
namespace {

constexpr double shareOfPale =
    0.72; // of the text on the ground of a chosen row: more than 3 : 1 in any palette

QColor mixed(const QColor &text, const QColor &ground)
{
    const auto part = [](float of, float with) {
        return static_cast<float>(shareOfPale * of + (1 - shareOfPale) * with);
    };
    return QColor::fromRgbF(part(text.redF(), ground.redF()), part(text.greenF(), ground.greenF()),
                            part(text.blueF(), ground.blueF()));
}

void makeChosenPale(QPalette &palette)
{
    for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive})
        palette.setColor(group, QPalette::HighlightedText,
                         mixed(palette.color(group, QPalette::HighlightedText),
                               palette.color(group, QPalette::Highlight)));
}

QColor colorOf(const QStyleOptionViewItem &option, QPalette::ColorRole unselected)
{
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const bool isActive = option.state.testFlag(QStyle::State_Active);
    return option.palette.color(isActive ? QPalette::Active : QPalette::Inactive,
                                isSelected ? QPalette::HighlightedText : unselected);
}

} // namespace

void StructureDelegate::initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.data(Qt::ForegroundRole).isValid())
        makeChosenPale(option->palette);
    if (index.column() == StructureModel::stateColumn && option->rect.width() <= stateIconWidth())
        option->text.clear();
}

void NameDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                         const QModelIndex &index) const
{
    const QString detail = index.data(StructureModel::detailRole).toString();
    if (detail.isEmpty()) {
        StructureDelegate::paint(painter, option, index);
        return;
    }
    QStyleOptionViewItem cell = option;
    initStyleOption(&cell, index);
    const QStyle *style = cell.widget != nullptr ? cell.widget->style() : QApplication::style();
    const QRect room = style->subElementRect(QStyle::SE_ItemViewItemText, &cell, cell.widget)
                           .adjusted(grid::unit / 2, 0, -grid::unit / 2, 0);
    cell.text.clear();
    style->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);

    painter->save();
    painter->setFont(cell.font);
    painter->setPen(colorOf(cell, QPalette::Text));
    const QString name = cell.fontMetrics.elidedText(index.data(StructureModel::nameRole).toString(),
                                                     Qt::ElideRight, room.width());
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, name);
    const QFont small = textFont(TextSize::small);
    const QRect behind = room.adjusted(cell.fontMetrics.horizontalAdvance(name) + grid::margin, 0, 0, 0);
    const QString text = QFontMetrics(small).elidedText(detail, Qt::ElideRight, behind.width());
    if (behind.width() > 0) {
        painter->setFont(small);
        painter->setPen(colorOf(cell, QPalette::PlaceholderText));
        painter->drawText(behind, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, text);
    }
    painter->restore();
}

} // namespace codewheel
