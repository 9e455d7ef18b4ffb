// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_delegate.h"

#include "widgets/look/appearance.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/wrapped_text.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/value_input.h"

#include <QApplication>
#include <QComboBox>
#include <QPainter>
#include <QTableView>

#include <algorithm>

namespace codewheel {

namespace {

constexpr int warningMarkSize = 12;

QColor inkOf(const QStyleOptionViewItem &option, bool isPale)
{
    if (option.state.testFlag(QStyle::State_Selected))
        return option.palette.color(QPalette::HighlightedText);
    return option.palette.color(isPale ? QPalette::PlaceholderText : QPalette::Text);
}

QRect inside(const QRect &cell)
{
    return cell.adjusted(grid::unit, grid::unit / 2, -grid::unit, -grid::unit / 2);
}

int roomOf(const QTableView &table, const QModelIndex &index)
{
    int width = -2 * grid::unit;
    for (int column = 0; column < table.columnSpan(index.row(), index.column()); ++column)
        width += table.columnWidth(index.column() + column);
    return width;
}

// What takes the room of the wanted value too begins below its own heading.
Qt::Alignment sideOf(const QStyleOptionViewItem &option, const QModelIndex &index)
{
    const auto *table = qobject_cast<const QTableView *>(option.widget);
    const bool isSpread = table != nullptr && table->columnSpan(index.row(), index.column()) > 1;
    return isSpread ? Qt::AlignLeft : option.displayAlignment;
}

void drawLine(QPainter &painter, const QRect &where, Qt::Alignment alignment, const QString &text)
{
    const QString shown = painter.fontMetrics().elidedText(text, Qt::ElideRight, where.width());
    painter.drawText(where, static_cast<int>((alignment & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter),
                     shown);
}

// What is too long for a line is elided, not broken: the tooltip has all of it.
QString withWordsElided(const QString &name, const QFontMetrics &metrics, int room)
{
    QStringList words = name.split(u' ');
    for (QString &word : words) {
        const QStringList parts = word.split(u'-');
        if (std::ranges::any_of(parts,
                                [&](const QString &part) { return metrics.horizontalAdvance(part) > room; }))
            word = metrics.elidedText(word, Qt::ElideRight, room);
    }
    return words.join(u' ');
}

// On two lines if necessary, or small if it still does not fit.
void drawName(QPainter &painter, const QRect &where, const QString &name)
{
    const auto flags = static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap);
    const QRect needed = painter.boundingRect(where, flags, name);
    if (needed.height() > where.height() || needed.width() > where.width())
        painter.setFont(textFont(TextSize::small));
    const QString shown = withWordsElided(name, painter.fontMetrics(), where.width());
    WrappedText(shown, painter.font(), where.width(), Qt::AlignLeft).draw(painter, where);
}

int longestWord(const QModelIndex &index, const QFontMetrics &metrics)
{
    int longest = 0;
    for (const QString &word : index.data().toString().split(u' '))
        longest = std::max(longest, metrics.horizontalAdvance(word));
    return longest;
}

// Small rather than broken within a word: "33.554." and "432" on two lines are misread.
QFont fontOf(const QString &value, const QFont &usual, int room)
{
    const QFontMetrics metrics(usual);
    for (const QString &word : value.split(u' '))
        if (metrics.horizontalAdvance(word) > room)
            return textFont(TextSize::small);
    return usual;
}

} // namespace

void ParameterDelegate::paint(QPainter *painter, const QStyleOptionViewItem &given,
                              const QModelIndex &index) const
{
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QString value = std::exchange(option.text, {});
    const QStyle *style = option.widget ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

    painter->save();
    painter->setClipRect(option.rect);
    QRect first = inside(option.rect);
    QString detail = index.data(ParameterModel::detailRole).toString();
    if (QFontMetrics(textFont(TextSize::small)).horizontalAdvance(detail) > first.width())
        detail = index.data(ParameterModel::shortDetailRole).toString();
    QRect second = first;
    if (!detail.isEmpty() && !value.isEmpty()) {
        const QFontMetrics small(textFont(TextSize::small));
        const int ofTwoLines = first.height() * 3 / 5;
        first.setBottom(std::max(first.top() + ofTwoLines, first.bottom() - small.height()));
        second.setTop(first.bottom());
    }
    const Qt::Alignment side = sideOf(option, index);
    painter->setFont(option.font);
    painter->setPen(inkOf(option, index.data(ParameterModel::isPaleRole).toBool()));
    if (index.column() == ParameterModel::nameColumn)
        drawName(*painter, first, value);
    else
        WrappedText(value, fontOf(value, option.font, first.width()), first.width(), side)
            .draw(*painter, first);

    painter->setFont(textFont(TextSize::small));
    painter->setPen(inkOf(option, true));
    drawLine(*painter, second, side, detail);
    if (const QVariant mark = index.data(ParameterModel::detailMarkRole); mark.isValid()) {
        const int width = painter->fontMetrics().horizontalAdvance(detail);
        const auto role = static_cast<Role>(mark.toInt());
        const QRect place(second.right() - width - warningMarkSize - grid::unit,
                          second.center().y() - warningMarkSize / 2, warningMarkSize, warningMarkSize);
        lineIcon(roleIcon(role), role)
            .paint(painter, place, Qt::AlignCenter,
                   option.state.testFlag(QStyle::State_Selected) ? QIcon::Selected : QIcon::Normal);
    }
    painter->restore();
}

QSize ParameterDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const auto font = qvariant_cast<QFont>(index.data(Qt::FontRole));
    const QFontMetrics big(font);
    const QFontMetrics small(textFont(TextSize::small));
    const bool isMarked = index.data(ParameterModel::detailMarkRole).isValid();
    const int width = std::max(big.horizontalAdvance(index.data().toString()),
                               small.horizontalAdvance(index.data(ParameterModel::detailRole).toString()) +
                                   (isMarked ? warningMarkSize + grid::unit : 0));
    const double factor = option.widget ? controlFactor(*option.widget) : 1;
    const int line = QFontMetrics(textFont()).height();
    const auto *table = qobject_cast<const QTableView *>(option.widget);
    const int room = table ? roomOf(*table, index) : width;
    // A value that is cut off could be a different one: it wraps to as many lines as it needs.
    const QString text = index.data().toString();
    const int value = index.column() == ParameterModel::nameColumn
                          ? line
                          : WrappedText(text, fontOf(text, font, room), room, Qt::AlignRight).height();
    return {width + 3 * grid::unit, std::max(line + value + grid::unit, qRound(26 * factor))};
}

int ParameterDelegate::leastWidth(const QModelIndex &index)
{
    const QFontMetrics small(textFont(TextSize::small));
    const bool isMarked = index.data(ParameterModel::detailMarkRole).isValid();
    const int detail = small.horizontalAdvance(index.data(ParameterModel::shortDetailRole).toString()) +
                       (isMarked ? warningMarkSize + grid::unit : 0) + 3 * grid::unit;
    return std::max(detail, longestWord(index, small) + 2 * grid::unit);
}

int ParameterDelegate::wordWidth(const QModelIndex &index)
{
    return longestWord(index, QFontMetrics(qvariant_cast<QFont>(index.data(Qt::FontRole)))) + 2 * grid::unit;
}

int ParameterDelegate::lineWidth(const QModelIndex &index)
{
    const QFontMetrics metrics(qvariant_cast<QFont>(index.data(Qt::FontRole)));
    return std::max(metrics.horizontalAdvance(index.data().toString()) + 2 * grid::unit, leastWidth(index));
}

QWidget *ParameterDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &,
                                         const QModelIndex &index) const
{
    const auto &model = static_cast<const ParameterModel &>(*index.model());
    const ParameterDescription &parameter = model.rowAt(index.row()).parameter;
    QWidget *editor = makeValueInput(parameter, tr("unchanged"), parent);
    editor->setAccessibleName(tr("Wanted: %1").arg(parameterName(parameter)));
    if (auto *number = qobject_cast<ValueInput *>(editor)) {
        connect(number, &ValueInput::inputChecked, this, [this, number, &model](const QString &wrong) {
            const auto value = inputValue(*number);
            Q_EMIT inputChecked(value && *value ? model.whyTaken({number->parameter(), **value}) : wrong);
        });
    } else if (auto *choices = qobject_cast<QComboBox *>(editor)) {
        auto *self = const_cast<ParameterDelegate *>(this);
        connect(choices, &QComboBox::activated, self, [self, choices] {
            Q_EMIT self->commitData(choices);
            Q_EMIT self->closeEditor(choices);
        });
    }
    return editor;
}

// As wide as its texts, if need be over the known value: an arrow takes room that the cell does not have.
void ParameterDelegate::updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
                                             const QModelIndex &) const
{
    const auto *table = qobject_cast<const QTableView *>(option.widget);
    const int farthest =
        table ? table->columnViewportPosition(ParameterModel::knownColumn) : option.rect.left();
    QRect place = option.rect;
    place.setLeft(std::max(farthest, place.right() + 1 - editor->minimumSizeHint().width()));
    editor->setGeometry(place.united(option.rect));
}

// What the user is typing is not overwritten by what comes from the bus.
void ParameterDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const
{
    if (const auto *number = qobject_cast<ValueInput *>(editor); number && number->isModified())
        return;
    const QVariant value = index.data(Qt::EditRole);
    setInputValue(*editor, valueFromVariant(value));
}

void ParameterDelegate::setModelData(QWidget *editor, QAbstractItemModel *model,
                                     const QModelIndex &index) const
{
    if (const auto value = inputValue(*editor))
        model->setData(index, variantOf(*value), Qt::EditRole);
}

} // namespace codewheel
