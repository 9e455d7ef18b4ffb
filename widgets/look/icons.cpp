// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/icons.h"

#include "widgets/look/line_icon_engine.h"

namespace codewheel {

QIcon lineIcon(Icon icon)
{
    return QIcon(new LineIconEngine(icon, std::nullopt));
}

QIcon lineIcon(Icon icon, Role role)
{
    return QIcon(new LineIconEngine(icon, role));
}

} // namespace codewheel
