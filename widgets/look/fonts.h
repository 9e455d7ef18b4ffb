// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>

namespace codewheel {

// The three sizes of all texts, relative to the system's font.
enum class TextSize : std::uint8_t { small, normal, large };

QFont textFont(TextSize size = TextSize::normal);

// For changing numbers and all hex: the system's fixed font, so that nothing jumps.
QFont numberFont(TextSize size = TextSize::normal);

} // namespace codewheel
