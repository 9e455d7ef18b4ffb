// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc_line/row_text.h"
#include "widgets/look/roles.h"

namespace codewheel {

// What passed on the line as the window shows it.

ControlCharacters shownControls(); // as the font for numbers has it
// Beside the word.
QIcon rowKindIcon(esc::LineRow::Kind kind);

} // namespace codewheel
