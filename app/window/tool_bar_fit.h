// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QToolBar;
class QToolButton;
class QWidget;

namespace codewheel {

class ModeSwitch;

// Sees to it that the tool bar has room for all of it, ALARM STOP at its end above all: where it is narrow,
// buttons lose their words, the last first, and keep their icons; the switch of the mode loses its own last.
// The window cannot be made narrower than that.
class ToolBarFit : public QObject
{
    Q_OBJECT

public:
    ToolBarFit(QToolBar &bar, ModeSwitch &mode, const QWidget &alarmStop);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void fit();
    QList<QToolButton *> buttons() const; // that can do without words
    int widthOf(const QToolButton &button, bool words) const;
    int widthOfRest() const;

    QToolBar &m_bar;
    ModeSwitch &m_mode;
    const QWidget &m_alarmStop;
    QToolButton *m_measured; // never seen: to ask how wide one would be
};

} // namespace codewheel
