// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/palette/palette_source.h"

class QAction;

namespace codewheel {

class OtherLanguage;

// An action of a menu, triggered exactly as by it. It is found by its text and what it does, by both in the
// other language, and by what people of the field call it, in both.
PaletteEntry paletteEntry(QAction &action, const QString &context, OtherLanguage &otherLanguage);

} // namespace codewheel
