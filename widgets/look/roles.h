// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/role.h"
#include "widgets/look/icons.h"

#include <QColor>
#include <QPalette>
#include <QString>

#include <array>

namespace codewheel {

// The meanings of colours. No other colours are used, and each is always shown with its icon and its word.
inline constexpr std::array allRoles{Role::running, Role::attention, Role::fault, Role::setBit,
                                     Role::inactive};

// Whether a palette is dark on light or light on dark.
enum class Shade : std::uint8_t { light, dark };
Shade shadeOf(const QPalette &palette);

// Fills, rims and icons: a contrast of at least 3 : 1 with the palette's backgrounds.
QColor roleColor(Role role, const QPalette &palette);
// Digits on a background of roleColor(): at least 4.5 : 1.
QColor textOn(Role role, const QPalette &palette);

QString roleWord(Role role);
Icon roleIcon(Role role);

} // namespace codewheel
