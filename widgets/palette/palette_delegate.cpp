// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/palette/palette_delegate.h"

#include "widgets/look/appearance.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/palette/folded_text.h"
#include "widgets/palette/palette_model.h"

#include <QApplication>
#include <QPainter>
#include <QTextLayout>

namespace codewheel {
namespace {

constexpr double paleShare = 0.75; // of the text on the ground of a chosen row

QFont inBold(QFont font)
{
    font.setBold(true);
    return font;
}

struct Inks
{
    QColor title;
    QColor context;
};

Inks inksOf(const QStyleOptionViewItem &option, bool isEnabled)
{
    const QPalette &palette = option.palette;
    if (!option.state.testFlag(QStyle::State_Selected))
        return {isEnabled ? palette.color(QPalette::Text) : palette.color(QPalette::PlaceholderText),
                palette.color(QPalette::PlaceholderText)};
    const QColor text = palette.color(QPalette::HighlightedText);
    QColor pale = text;
    pale.setAlphaF(paleShare);
    return {isEnabled ? text : pale, text};
}

} // namespace

PaletteDelegate::PaletteDelegate(const PaletteModel &model, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_model(model)
{}

int PaletteDelegate::rowHeight(const QWidget &view)
{
    const int lines = QFontMetrics(inBold(textFont())).height() +
                      QFontMetrics(textFont(TextSize::small)).height() + grid::margin;
    return qRound(lines * controlFactor(view));
}

QSize PaletteDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &) const
{
    return {0, rowHeight(*option.widget)};
}

// What is cut off is in the tooltip.
void PaletteDelegate::drawLine(QPainter &painter, const QRect &where, const QString &text,
                               const QFont &font) const
{
    const auto marks = marksOf(text, m_model.words());
    const QFontMetrics widest(marks.empty() ? font : inBold(font));
    const QString shown = widest.elidedText(text, Qt::ElideRight, where.width());
    QList<QTextLayout::FormatRange> formats;
    for (const auto &[begin, length] : marks)
        if (begin < shown.size()) {
            QTextLayout::FormatRange bold;
            bold.start = begin;
            bold.length = std::min(length, static_cast<int>(shown.size()) - begin);
            bold.format.setFontWeight(QFont::Bold);
            formats << bold;
        }
    QTextLayout layout(shown, font);
    layout.setFormats(formats);
    layout.beginLayout();
    layout.createLine().setLineWidth(2 * where.width());
    layout.endLayout();
    layout.draw(&painter, where.topLeft());
}

void PaletteDelegate::paint(QPainter *painter, const QStyleOptionViewItem &given,
                            const QModelIndex &index) const
{
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QIcon icon = std::exchange(option.icon, {});
    const QString title = std::exchange(option.text, {});
    option.features &= ~QStyleOptionViewItem::HasDecoration;
    const QStyle *style = option.widget ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

    const bool isEnabled = index.data(PaletteModel::isEnabledRole).toBool();
    const bool isChosen = option.state.testFlag(QStyle::State_Selected);
    const Inks inks = inksOf(option, isEnabled);
    QRect room = option.rect.adjusted(grid::margin, 0, -grid::margin, 0);
    const QRect iconPlace(room.left(), room.center().y() - grid::smallIcon / 2, grid::smallIcon,
                          grid::smallIcon);
    painter->save();
    icon.paint(painter, iconPlace, Qt::AlignCenter,
               isChosen    ? QIcon::Selected
               : isEnabled ? QIcon::Normal
                           : QIcon::Disabled);
    room.setLeft(iconPlace.right() + grid::margin);

    const int big = QFontMetrics(inBold(textFont())).height();
    const QFontMetrics small(textFont(TextSize::small));
    QRect first(room.left(), room.center().y() - (big + small.height()) / 2, room.width(), big);
    const QRect second(first.left(), first.bottom() + 1, room.width(), small.height());
    painter->setFont(textFont());
    painter->setPen(inks.context);
    if (const QString key = index.data(PaletteModel::keyRole).toString(); !key.isEmpty()) {
        painter->drawText(first, static_cast<int>(Qt::AlignRight | Qt::AlignVCenter), key);
        first.setRight(first.right() - painter->fontMetrics().horizontalAdvance(key) - 2 * grid::margin);
    }
    painter->setPen(inks.title);
    drawLine(*painter, first, title, textFont());
    painter->setPen(inks.context);
    drawLine(*painter, second, index.data(PaletteModel::contextRole).toString(), textFont(TextSize::small));
    painter->restore();
}

} // namespace codewheel
