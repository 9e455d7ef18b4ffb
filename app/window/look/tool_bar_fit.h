// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QToolBar;
class QToolButton;
class QWidget;

namespace codewheel {

class ModeSwitch;

// Makes everything fit into the tool bar, above all ALARM STOP at its end: if it is narrow, buttons lose
// their words, the last ones first, but keep their icons; the mode switch is the last to lose its words. The
// window cannot be made narrower than that.
class ToolBarFit : public QObject
{
    Q_OBJECT

public:
    ToolBarFit(QToolBar &bar, ModeSwitch &mode, const QWidget &alarmStop);

private:
    void fit();
    QList<QToolButton *> buttons() const; // those that can do without words
    int widthOf(const QToolButton &button, bool words) const;
    int widthOfRest() const;

    QToolBar &m_bar;
    ModeSwitch &m_mode;
    const QWidget &m_alarmStop;
    QToolButton *m_measured; // never shown: measures the width of a button
};

} // namespace codewheel
