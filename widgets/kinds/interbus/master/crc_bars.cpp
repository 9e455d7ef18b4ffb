// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/master/crc_bars.h"

#include "kinds/interbus/ring/crc_history.h"
#include "widgets/kinds/interbus/master/segment_model.h"
#include "widgets/look/grid.h"
#include "widgets/look/roles.h"

#include <QPainter>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int barWidth = 3; // where there is room
constexpr int barGap = 1;

} // namespace

void CrcBars::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    QStyledItemDelegate::paint(painter, option, index);
    const QVariantList counts = index.data(SegmentModel::countsRole).toList();
    int tallest = 1;
    for (const QVariant &count : counts)
        tallest = std::max(tallest, count.toInt());
    const QRect room = option.rect.adjusted(grid::unit, grid::unit / 2, -grid::unit, -grid::unit / 2);
    painter->save();
    painter->setPen(option.palette.color(QPalette::Mid));
    painter->drawLine(room.bottomLeft(), room.bottomRight());
    const QColor color = roleColor(Role::fault, option.palette);
    const auto left = [&](qsizetype bar) {
        return room.left() + static_cast<int>(room.width() * bar / std::max(qsizetype{1}, counts.size()));
    };
    for (qsizetype bar = 0; bar < counts.size(); ++bar) {
        const int errors = counts[bar].toInt();
        if (errors <= 0)
            continue;
        const int height = std::max(2, room.height() * errors / tallest);
        const int width = std::max(1, left(bar + 1) - left(bar) - barGap);
        painter->fillRect(left(bar), room.bottom() - height + 1, width, height, color);
    }
    painter->restore();
}

QSize CrcBars::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const QSize text = QStyledItemDelegate::sizeHint(option, index);
    return {static_cast<int>(CrcHistory::intervals) * (barWidth + barGap) + 2 * grid::unit, text.height()};
}

} // namespace codewheel
