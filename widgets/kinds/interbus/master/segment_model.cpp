// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/master/segment_model.h"

#include "kinds/interbus/ring/ring_session.h"
#include "widgets/look/roles.h"

#include <QLocale>

#include <numeric>

namespace codewheel {
namespace {

QString historyText(const SegmentRow &row)
{
    const auto sum = std::accumulate(row.history.counts.begin(), row.history.counts.end(), 0U);
    return SegmentModel::tr("%n errors in the last five minutes", nullptr, static_cast<int>(sum));
}

bool isShownSame(const SegmentRow &a, const SegmentRow &b)
{
    return a.segment == b.segment && a.switchedOff == b.switchedOff && a.crcErrors == b.crcErrors &&
           a.history.counts == b.history.counts && a.last == b.last;
}

} // namespace

void SegmentModel::show(const RingSession &bus)
{
    std::vector<SegmentRow> fresh;
    if (const MasterStatus *master = bus.master())
        for (const MasterStatus::Segment &segment : master->segments) {
            const CrcHistory::Segment history = bus.crcHistory().of(segment.segment);
            fresh.push_back({segment.segment, segment.switchedOff, segment.crcErrors, history,
                             history.last ? bus.dateTime(*history.last) : QDateTime()});
        }
    if (fresh.size() != rows().size()) {
        setRows(std::move(fresh));
        return;
    }
    for (int row = 0; row < rowCount(); ++row)
        if (const SegmentRow &newest = fresh[static_cast<std::size_t>(row)]; !isShownSame(newest, rowAt(row)))
            replace(row, newest);
}

std::span<const ColumnHead> SegmentModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Segment")},
        {QT_TR_NOOP("State")},
        {QT_TR_NOOP("CRC errors"), Qt::AlignRight},
        {QT_TR_NOOP("5 minutes"),
         {},
         QT_TR_NOOP("The CRC errors of the last five minutes, the newest at the right")},
        {QT_TR_NOOP("Last error"), {}, QT_TR_NOOP("When the last CRC error was counted")},
    };
    return all;
}

QVariant SegmentModel::valueOf(const SegmentRow &row, int column) const
{
    switch (column) {
    case segmentColumn:
        return row.segment;
    case stateColumn:
        return row.switchedOff ? tr("off") : tr("on");
    case crcColumn:
        return QLocale().toString(row.crcErrors);
    case lastColumn:
        return row.last.isNull() ? QString(QChar(0x2013))
                                 : QLocale().toString(row.last.time(), QLocale::ShortFormat);
    default:
        return {}; // drawn by CrcBars
    }
}

QVariant SegmentModel::cell(const SegmentRow &row, int column, int role) const
{
    if (role == Qt::DisplayRole)
        return valueOf(row, column);
    if (role == Qt::DecorationRole && column == stateColumn) {
        const Role state = row.switchedOff ? Role::attention : Role::running;
        return lineIcon(roleIcon(state), state);
    }
    if (column == historyColumn && (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole))
        return historyText(row);
    if (column == historyColumn && role == countsRole) {
        QVariantList counts;
        for (const std::uint32_t count : row.history.counts)
            counts.append(count);
        return counts;
    }
    if (role == Qt::TextAlignmentRole && column == crcColumn)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

} // namespace codewheel
