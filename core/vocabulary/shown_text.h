// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// Text of unknown origin (a file, a device, an argument), safe for a terminal and a text file: what would
// control the terminal or change the direction of the text around it is shown as an escape, "\u001B" as in
// JSON, so that it is the same text in a JSON string. That covers control characters (C0, DEL, C1),
// directional marks, embeddings, overrides and isolates, line and paragraph separators, the byte order mark,
// and halves of surrogate pairs. Line breaks and tabs stay.
QString shownText(const QString &text);

// The same for a name, a path or a cell: line breaks and tabs are escaped too.
QString shownInLine(const QString &text);

} // namespace codewheel
