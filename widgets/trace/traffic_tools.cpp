// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trace/traffic_tools.h"

#include "widgets/look/log_table.h"
#include "widgets/look/tool.h"

#include <QAction>

namespace codewheel {

TrafficTools::TrafficTools(QWidget &view, QToolBar &bar, LogTable &table, const QKeySequence &copyKey)
{
    setUpToolBar(bar);
    const auto make = [&](const Tool &tool) { return addTool(view, bar, tool); };
    follow = make(
        {Icon::next, tr("Follow"), QKeySequence(Qt::CTRL | Qt::Key_End), tr("Keep the newest row in view")});
    hold = make({Icon::stop, tr("Pause"), QKeySequence(Qt::CTRL | Qt::Key_H),
                 tr("Hold the table; new rows are kept and shown afterwards")});
    copy = make({Icon::copy, tr("Copy"), copyKey,
                 tr("Copy the selected rows, or all shown, with tabs between the columns")});
    exportRows = make({Icon::exportData, tr("Export"), QKeySequence(Qt::CTRL | Qt::Key_E),
                       tr("Write the rows shown to a file")});
    clear = make({Icon::remove, tr("Clear"), QKeySequence(Qt::CTRL | Qt::Key_Delete), tr("Remove all rows")});
    bringBack = make({Icon::back, tr("Bring back"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Delete),
                      tr("Show the rows again that Clear removed")});
    for (QAction *each : {follow, hold})
        each->setCheckable(true);
    follow->setChecked(true);
    bringBack->setEnabled(false);
    table.setFollow(*follow);
}

} // namespace codewheel
