// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"
#include "widgets/look/roles.h"

#include <QPointer>
#include <QWidget>

#include <vector>

class QLabel;
class QStatusBar;

namespace codewheel {

class RoleLabel;

// The line at the foot of the window: state of the bus, what the views of each bus tell of it, and what the
// chosen encoder's memory has had from here. Numbers that change stand in the fixed font. It never widens the
// window: in a narrow one it leaves out what also stands in the panels.
class StatusLine : public QObject
{
    Q_OBJECT

public:
    StatusLine(QStatusBar &bar, QObject *parent);

    // For the views of a bus, who delete what they got. What is left out first has the highest rank.
    QLabel *addFigure(int rank, const QString &name, const QString &toolTip);
    RoleLabel *addState();
    void show(QLabel *figure, const QString &text); // nothing, where it is empty
    void fit();                                     // after something of it changed

    void setState(Role role, const QString &text); // of the bus that has a master
    // Of the chosen bus; with its name, where the state beside it is that of another one.
    void setMode(bool isOperating, const QString &bus = {});
    // What is wrong with buses that are not shown in the line: "Ring 2: BUS FAIL".
    void setOtherFaults(const QStringList &faults);
    void setEncoder(EncoderSession *encoder);
    void showFrame();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Figure
    {
        int rank = 0;
        QPointer<QLabel> label;
    };

    void add(QWidget *widget);

    QStatusBar &m_bar;
    QPointer<EncoderSession> m_encoder;
    RoleLabel *m_state;
    RoleLabel *m_mode;
    RoleLabel *m_otherFaults;
    QStringList m_faultsTold;
    QLabel *m_hint; // what the mouse or the focus is on
    QLabel *m_writes;
    int m_added = 0;                         // between mode and hint
    std::vector<Figure> m_figures;           // by rank
    std::vector<QPointer<QWidget>> m_always; // never left out
};

} // namespace codewheel
