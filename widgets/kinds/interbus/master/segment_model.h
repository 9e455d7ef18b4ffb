// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/crc_history.h"
#include "widgets/models/table_model_base.h"

#include <QDateTime>

namespace codewheel {

class RingSession;

// A segment of the ring: on or off, and its CRC errors.
struct SegmentRow
{
    int segment = 0;
    bool switchedOff = false;
    std::uint32_t crcErrors = 0; // since the ring was started
    CrcHistory::Segment history;
    QDateTime last; // time of the last error; null: none
};

// The segments of the ring as reported by the master. Used by the master panel.
class SegmentModel : public TableModelBase<SegmentRow>
{
    Q_OBJECT

public:
    enum Column { segmentColumn, stateColumn, crcColumn, historyColumn, lastColumn };
    static constexpr int countsRole = Qt::UserRole; // QVariantList of the counts of historyColumn

    using TableModelBase::TableModelBase;

    // Notifies the views only of what has changed.
    void show(const RingSession &bus);

private:
    std::span<const ColumnHead> heads() const override;
    QVariant cell(const SegmentRow &row, int column, int role) const override;
    QVariant valueOf(const SegmentRow &row, int column) const;
};

} // namespace codewheel
