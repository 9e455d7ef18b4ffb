// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/device_number.h"

#include <QWidget>

#include <optional>

class QLabel;
class QStatusBar;

namespace codewheel {

class BusSession;
class EncoderSession;
class RoleLabel;

// The line at the foot of the window: state of the bus, cycle, link, and what the chosen encoder's memory has
// had from here. Numbers that change stand in the fixed font.
class StatusLine : public QObject
{
    Q_OBJECT

public:
    StatusLine(QStatusBar &bar, QObject *parent);

    void setBus(BusSession *bus, const QString &link);
    void setEncoder(EncoderSession *encoder);

private:
    void refresh();
    void showState();

    BusSession *m_bus = nullptr;
    EncoderSession *m_encoder = nullptr;
    QString m_link;
    RoleLabel *m_state;
    RoleLabel *m_mode;
    QLabel *m_cycle;
    QLabel *m_late;
    QLabel *m_linkLabel;
    QLabel *m_hint; // what the mouse or the focus is on
    QLabel *m_writes;
};

} // namespace codewheel
