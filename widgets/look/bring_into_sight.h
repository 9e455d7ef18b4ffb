// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace codewheel {

// In each area around it that scrolls.
inline void bringIntoSight(QWidget &widget)
{
    for (QWidget *around = widget.parentWidget(); around != nullptr; around = around->parentWidget())
        if (auto *area = qobject_cast<QScrollArea *>(around); area != nullptr && area->widget() != nullptr)
            area->ensureWidgetVisible(&widget, 0, 0);
}

} // namespace codewheel
