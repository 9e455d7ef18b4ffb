// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/traffic_model_base.h"
#include "widgets/trace/trace_row.h"

namespace codewheel {

// The exchanges of one encoder.
class TraceModel : public TrafficModelBase<TraceRow>
{
    Q_OBJECT

public:
    enum Column { time, sinceLast, cycle, out, in, meaning, remark };
    static constexpr int mostRows = 20'000;

    explicit TraceModel(DeviceDescription device, QObject *parent = nullptr);

    const DeviceDescription &device() const { return m_device; }

    void add(const Exchange &exchange, const QDateTime &at);
    void clear();

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;

Q_SIGNALS:
    void countsChanged();

protected:
    int columns() const override { return remark + 1; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const TraceRow &row, int column, int role) const override;

private:
    void tellCounts() override { Q_EMIT countsChanged(); }
    QString text(const TraceRow &row, int column) const;

    DeviceDescription m_device;
    std::optional<Exchange> m_last;
};

} // namespace codewheel
