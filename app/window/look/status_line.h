// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"
#include "widgets/look/roles.h"

#include <QPointer>
#include <QWidget>

#include <vector>

class QLabel;
class QStatusBar;

namespace codewheel {

class RoleLabel;

// The line at the bottom of the window: state of the bus, figures from the views of each bus, and the EEPROM
// writes made from here to the chosen encoder. Changing numbers are in the fixed font. It never widens the
// window: in a narrow one it leaves out or shortens what the panels also show.
class StatusLine : public QObject
{
    Q_OBJECT

public:
    StatusLine(QStatusBar &bar, QObject *parent);

    // For the views of a bus, which delete what they got. The highest rank is left out first.
    QLabel *addFigure(int rank, const QString &name, const QString &toolTip);
    RoleLabel *addState();
    void addAlways(QWidget *widget);                // is never left out
    void show(QLabel *figure, const QString &text); // takes no room if the text is empty
    void fit();                                     // after any of them has changed

    void setState(Role role, const QString &text); // of the bus that has a master
    // For the chosen bus; with its name if the state beside it is that of another one.
    void setRecorded(const QString &bus); // instead of its mode
    void setMode(bool isOperating, const QString &bus = {});
    // Faults of buses not shown in the line: "Ring 2: BUS FAIL".
    void setOtherFaults(const QStringList &faults);
    void setEncoder(EncoderSession *encoder);
    void showFrame();

private:
    void showHint();
    struct Figure
    {
        int rank = 0;
        QPointer<QLabel> label;
    };

    void add(QWidget *widget);
    void fitWrites(int room);

    QStatusBar &m_bar;
    QPointer<EncoderSession> m_encoder;
    RoleLabel *m_state;
    RoleLabel *m_mode;
    RoleLabel *m_otherFaults;
    QStringList m_faultsTold;
    QLabel *m_hint; // status tip for the mouse or the focus
    QLabel *m_writes;
    QString m_writesText;                    // in full
    int m_added = 0;                         // between mode and hint
    std::vector<Figure> m_figures;           // by rank
    std::vector<QPointer<QWidget>> m_always; // never left out
};

} // namespace codewheel
