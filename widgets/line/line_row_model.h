// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc_line/line_record.h"
#include "widgets/line/line_row_text.h"
#include "widgets/models/traffic_model_base.h"

#include <QDateTime>

namespace codewheel {

struct ShownLineRow
{
    LineRecord::Row row;
    std::optional<esc::Request> request; // that was sent, or that was sent before what came in

    // Asked for by the polling, and nothing is wrong with it.
    bool isPoll() const;
};

// What passed on a line. New rows wait until they are shown all together.
class LineRowModel : public TrafficModelBase<ShownLineRow>
{
    Q_OBJECT

public:
    enum Column { time, kind, text, meaning, bytes };
    static constexpr int mostRows = static_cast<int>(LineRecord::mostRows);

    explicit LineRowModel(QObject *parent = nullptr);

    // What Instant 0 of the rows stands for. Only while there are no rows.
    void setBegin(const QDateTime &begin);
    const QDateTime &begin() const { return m_begin; }
    void setExplainOptions(const esc::ExplainOptions &options);

    void add(const esc::LineRow &row);
    // The exchange that ended last was typed: all its rows are.
    void markTyped(const esc::Request &request);

    // All rows anew, as they were kept.
    void setRecord(const LineRecord &record);
    std::vector<LineRecord::Row> recordRows() const; // those that wait too

    // As on the screen; exported with control characters as pictures, and the time with its date.
    QString cellText(const ShownLineRow &row, int column, ControlCharacters controls = shownControls()) const;
    QString dateTimeText(const ShownLineRow &row) const;

Q_SIGNALS:
    void countsChanged();

protected:
    int columns() const override { return bytes + 1; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const ShownLineRow &row, int column, int role) const override;

private:
    void tellCounts() override { Q_EMIT countsChanged(); }
    ShownLineRow shown(LineRecord::Row row);
    QDateTime dateTime(const ShownLineRow &row) const;

    QDateTime m_begin;
    esc::ExplainOptions m_options;
    std::optional<esc::Request> m_lastRequest;
};

} // namespace codewheel
