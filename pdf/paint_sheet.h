// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdf/sheet.h"

class QPainter;

namespace codewheel {

// Paints the sheet in its dots, black on whatever is there.
void paintSheet(QPainter &painter, const Sheet &sheet);

} // namespace codewheel
