// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/device_number.h"
#include "encoder/encoder_session.h"

#include <QPointer>
#include <QWidget>

#include <optional>

class QLabel;
class QStatusBar;

namespace codewheel {

class BusSession;
class LineSession;
class RoleLabel;

// The line at the foot of the window: state of the bus, cycle, link, and what the chosen encoder's memory has
// had from here. Numbers that change stand in the fixed font. It never widens the window: in a narrow one it
// leaves out what also stands in the panels.
class StatusLine : public QObject
{
    Q_OBJECT

public:
    StatusLine(QStatusBar &bar, QObject *parent);

    void setBus(BusSession *bus, const QString &link);
    void setLine(LineSession *line); // null: none
    void setMode(bool isOperating);  // of the chosen bus
    void setEncoder(EncoderSession *encoder);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void fit();
    void refresh();
    void showState();
    void showLine();
    void showWrites();

    QStatusBar &m_bar;
    QPointer<BusSession> m_bus;
    QPointer<LineSession> m_line;
    QPointer<EncoderSession> m_encoder;
    QString m_link;
    bool m_isOperating = false;
    RoleLabel *m_state;
    RoleLabel *m_mode;
    QLabel *m_cycle;
    QLabel *m_late;
    QLabel *m_crc;
    QLabel *m_linkLabel;
    RoleLabel *m_lineLabel; // port, baud rate, and who answers
    QLabel *m_hint;         // what the mouse or the focus is on
    QLabel *m_writes;
};

} // namespace codewheel
