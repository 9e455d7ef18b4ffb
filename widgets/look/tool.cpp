// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/tool.h"

#include "widgets/look/grid.h"

#include <QAction>
#include <QToolBar>

namespace codewheel {

QAction *addTool(QWidget &view, QToolBar &bar, const Tool &tool)
{
    auto *action = new QAction(lineIcon(tool.icon), tool.text, &view);
    action->setShortcut(tool.key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(tool.tip, tool.key.toString(QKeySequence::NativeText)));
    view.addAction(action);
    bar.addAction(action);
    return action;
}

void setUpToolBar(QToolBar &bar)
{
    bar.setIconSize({grid::smallIcon, grid::smallIcon});
    bar.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
}

} // namespace codewheel
