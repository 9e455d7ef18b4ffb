// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// Text of unknown origin (a file, a device, an argument) as it may stand on a terminal and in a text file:
// what would steer the terminal or turn the direction of what stands around it is shown as an escape,
// "\u001B" as in JSON, so that it is the same text in a JSON string. That is control characters (C0, DEL,
// C1), marks, embeddings, overrides and isolates of direction, line and paragraph separators, the byte order
// mark, and halves of surrogate pairs. Line breaks and tabs stay.
QString shownText(const QString &text);

// The same for a name, a path or a cell: line breaks and tabs are escapes too.
QString shownInLine(const QString &text);

} // namespace codewheel
