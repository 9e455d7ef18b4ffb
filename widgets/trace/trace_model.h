// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/table_model_base.h"
#include "widgets/trace/trace_row.h"

namespace codewheel {

// The exchanges of one encoder, the newest last; the oldest go when there are too many. While it is held, new
// rows wait and come when it is let go.
class TraceModel : public TableModelBase<TraceRow>
{
    Q_OBJECT

public:
    enum Column { time, sinceLast, cycle, out, in, meaning, remark };
    static constexpr int mostRows = 20'000;

    explicit TraceModel(DeviceDescription device, QObject *parent = nullptr);

    const DeviceDescription &device() const { return m_device; }

    void add(const Exchange &exchange, const QDateTime &at);
    void setHeld(bool held);
    bool isHeld() const { return m_held; }
    int waiting() const { return static_cast<int>(m_waiting.size()); }
    quint64 dropped() const { return m_dropped; } // since it was cleared
    // All rows go, also those that wait; bringBack() shows them again, before those that came since.
    void clear();
    void bringBack();

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;

Q_SIGNALS:
    void countsChanged();

protected:
    int columns() const override { return remark + 1; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const TraceRow &row, int column, int role) const override;

private:
    QString text(const TraceRow &row, int column) const;
    void dropOldest();

    DeviceDescription m_device;
    std::vector<TraceRow> m_waiting;
    std::optional<Exchange> m_last;
    bool m_held = false;
    quint64 m_dropped = 0;
    quint64 m_droppedBefore = 0; // it was cleared
};

} // namespace codewheel
