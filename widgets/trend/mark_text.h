// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/mark.h"
#include "widgets/look/roles.h"

namespace codewheel {

// What a mark says: the message with the place it concerns, or the note.
QString markText(const Mark &mark);
QColor markColor(const Mark &mark, const QPalette &palette);

} // namespace codewheel
