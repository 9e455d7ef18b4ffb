// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/monitor_display.h"

#include <QMenu>

namespace codewheel {

// The Show menu of a monitor.
class DisplayMenu : public QMenu
{
    Q_OBJECT

public:
    explicit DisplayMenu(QWidget *parent = nullptr);

    void setDisplay(const MonitorDisplay &display);
    const MonitorDisplay &display() const { return m_display; }

Q_SIGNALS:
    void chosen(const codewheel::MonitorDisplay &display); // by the user

private:
    void addFlag(const QString &text, bool MonitorDisplay::*value);

    MonitorDisplay m_display;
    std::vector<std::pair<QAction *, bool MonitorDisplay::*>> m_flags;
};

} // namespace codewheel
