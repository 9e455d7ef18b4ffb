// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/table_model_base.h"

namespace codewheel {

// A table of what passes on a bus, the newest last; the oldest rows go when there are too many. While it is
// held, new rows wait and come when it is let go. What was cleared can be brought back. A child has a signal
// for the counts.
template <typename Row>
class TrafficModelBase : public TableModelBase<Row>
{
public:
    bool isHeld() const { return m_held; }
    int waiting() const { return static_cast<int>(m_waiting.size()); }
    quint64 dropped() const { return m_dropped; } // since it was cleared
    bool isEmpty() const { return this->rowCount() == 0 && m_waiting.empty(); }

    void setHeld(bool held)
    {
        m_held = held;
        showWaiting();
    }
    void showWaiting()
    {
        if (!m_held) {
            this->append(std::exchange(m_waiting, {}));
            dropOldest();
        }
        tellCounts();
    }
    // All rows go, also those that wait; bringBack() shows them again, before those that came since.
    void clear()
    {
        this->clearRows(std::exchange(m_waiting, {}), m_most);
        m_droppedBefore += std::exchange(m_dropped, 0);
        tellCounts();
    }
    void bringBack()
    {
        this->bringRowsBack();
        m_dropped += std::exchange(m_droppedBefore, 0);
        dropOldest();
        tellCounts();
    }

protected:
    // Beyond `most` rows so many are dropped at once that it is seldom.
    TrafficModelBase(int most, int droppedAtOnce, QObject *parent)
        : TableModelBase<Row>(parent)
        , m_most(most)
        , m_droppedAtOnce(droppedAtOnce)
    {}

    // Until showWaiting().
    void addWaiting(Row row)
    {
        m_waiting.push_back(std::move(row));
        if (waiting() <= m_most)
            return;
        m_waiting.erase(m_waiting.begin(), m_waiting.begin() + m_droppedAtOnce);
        m_dropped += static_cast<quint64>(m_droppedAtOnce);
    }
    std::vector<Row> &waitingRows() { return m_waiting; }
    const std::vector<Row> &waitingRows() const { return m_waiting; }
    virtual void tellCounts() = 0;

private:
    void dropOldest()
    {
        if (this->rowCount() <= m_most)
            return;
        const int surplus = std::max(this->rowCount() - m_most, m_droppedAtOnce);
        this->removeFirst(surplus);
        m_dropped += static_cast<quint64>(surplus);
    }

    const int m_most;
    const int m_droppedAtOnce;
    std::vector<Row> m_waiting;
    bool m_held = false;
    quint64 m_dropped = 0;
    quint64 m_droppedBefore = 0; // it was cleared
};

} // namespace codewheel
