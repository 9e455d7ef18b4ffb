// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_delegate.h"

#include "widgets/structure/structure_columns.h"
#include "widgets/structure/structure_model.h"

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

} // namespace

void StructureDelegate::initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.data(Qt::ForegroundRole).isValid())
        makeChosenPale(option->palette);
    if (index.column() == StructureModel::stateColumn && option->rect.width() <= stateIconWidth())
        option->text.clear();
}

} // namespace codewheel
