// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/palette/palette_source.h"

namespace codewheel {

QString kindWord(PaletteEntry::Kind kind);
QString whatReturnDoes(const PaletteEntry &entry);
QIcon kindIcon(PaletteEntry::Kind kind); // of entries without one of their own

} // namespace codewheel
