// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

class QLabel;

namespace codewheel {

class RingSession;
class StatusLine;

// What the status line shows of a ring: state of the master, cycle, errors, link. Used by RingViews.
class RingStatus
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingStatus)
    Q_DISABLE_COPY_MOVE(RingStatus)

public:
    explicit RingStatus(StatusLine &line);
    ~RingStatus();

    // `gateway`: as known to the user; empty: a training bus.
    void show(const RingSession &bus, const QString &gateway);
    void clear(); // another ring is shown, or none

private:
    StatusLine &m_line;
    QLabel *m_cycle;
    QLabel *m_late;
    QLabel *m_crc;
    QLabel *m_link;
};

} // namespace codewheel
