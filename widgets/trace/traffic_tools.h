// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QKeySequence>

class QAction;
class QToolBar;
class QWidget;

namespace codewheel {

class LogTable;

// The tools of a table of traffic, in a tool bar and, as far as they are about rows, in its menu: to follow,
// to pause, to copy, to export, to clear it, and to bring back what was cleared. What they do is the view's.
struct TrafficTools
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::TrafficTools)

public:
    // `copyKey`: of copying, where a field of the view has the usual one.
    TrafficTools(QWidget &view, QToolBar &bar, LogTable &table,
                 const QKeySequence &copyKey = QKeySequence::Copy);

    QAction *follow;
    QAction *hold;
    QAction *copy;
    QAction *exportRows;
    QAction *clear;
    QAction *bringBack;
};

} // namespace codewheel
