// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/traffic.h"
#include "widgets/models/table_model_base.h"

#include <span>

namespace codewheel {

struct ShownTraffic
{
    TrafficRow what;
    std::optional<Instant> sinceLast{}; // nothing for the first row
    QString remark{};
    bool beginsConnection = false; // nothing passed: what follows is of another connection
};

ControlCharacters shownControls(); // as far as the number font has them

// The traffic of a bus, newest last. When there are too many rows, the oldest automatic ones are dropped
// first, and what was typed, with its answers, last. While it is held, new rows wait until it is released.
// Cleared rows can be brought back. Behind the handshake trace and the terminal of a line.
class TrafficModel : public TableModelBase<ShownTraffic>
{
    Q_OBJECT

public:
    // `columns` are those of the bus, and outlive the model.
    TrafficModel(std::span<const TrafficColumn> columns, int most, QObject *parent = nullptr);

    int columnOf(TrafficColumn column) const; // columnCount(): it has none
    TrafficColumn columnAt(int column) const { return m_columns[static_cast<std::size_t>(column)]; }

    void setMost(int most); // rows, from the next one on
    bool isHeld() const { return m_held; }
    void setHeld(bool held);
    const std::vector<ShownTraffic> &waitingRows() const { return m_waiting; }
    int waiting() const { return static_cast<int>(m_waiting.size()); }
    quint64 dropped() const { return m_dropped; } // since it was cleared
    bool isEmpty() const { return rowCount() == 0 && m_waiting.empty(); }

    void add(TrafficRow row); // waits until showWaiting()
    void showWaiting();
    // What comes is of another connection: a row says so, unless there is nothing before it.
    void beginConnection(const QDateTime &time);
    // The last exchange, which began with sending this, was typed: marks all its rows.
    void markTyped(const QByteArray &sent);
    void tellMeaningsChanged();
    // Has the rows of another model, in place of its own.
    void goOnFrom(const TrafficModel &before);
    // Removes all rows, including waiting ones; bringBack() restores them before newer ones.
    void clear();
    void bringBack();

    // As on the screen; in exports, control characters are shown as symbols and the time has its date.
    QString cellText(const ShownTraffic &row, TrafficColumn column,
                     ControlCharacters controls = shownControls()) const;
    // In the locale's short format.
    QString dateTimeText(const ShownTraffic &row) const;
    // "9 rows; paused, 3 new; 500 older ones not kept", or "2 of 9 rows shown; ..." where a filter hides the
    // others.
    QString countsText(int shown) const;
    // A table for other programs, with a header: comma-separated, UTF-8, time in ISO 8601, whatever the
    // locale.
    QByteArray csv(Place place) const;

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;

Q_SIGNALS:
    void countsChanged();

protected:
    int columns() const override { return static_cast<int>(m_columns.size()); }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const ShownTraffic &row, int column, int role) const override;

private:
    struct Moment
    {
        Instant at{};
        QDateTime time{};
    };
    static std::optional<Instant> between(const Moment &last, const Moment &now);
    void dropOldest();
    std::vector<bool> chooseSurplus(const std::vector<ShownTraffic> &rows) const; // a flag for each row

    const std::span<const TrafficColumn> m_columns;
    int m_most;
    int m_droppedAtOnce; // so that dropping is rare
    std::vector<ShownTraffic> m_waiting;
    std::optional<Moment> m_last;
    bool m_held = false;
    quint64 m_dropped = 0;
    quint64 m_droppedBefore = 0; // before it was cleared
};

} // namespace codewheel
