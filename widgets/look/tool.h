// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/icons.h"

#include <QKeySequence>
#include <QString>

class QAction;
class QToolBar;
class QWidget;

namespace codewheel {

// A button in the tool bar of a view.
struct Tool
{
    Icon icon = Icon::add;
    QString text;
    QKeySequence key; // works anywhere in the view; shown in the tooltip
    QString tip;
};

// Shows it at the end of `bar`; its action belongs to `view`.
QAction *addTool(QWidget &view, QToolBar &bar, const Tool &tool);

// Small icons with their texts beside them, as long as there is room for all of them.
void setUpToolBar(QToolBar &bar);

} // namespace codewheel
