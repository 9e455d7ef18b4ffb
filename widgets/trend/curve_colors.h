// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

#include <cstddef>

namespace codewheel {

// Colours that only tell curves apart, each beside its name: safe for colour-blind eyes, and none of those
// that mean running, attention or fault. They repeat after the last one.
QColor curveColor(std::size_t index, const QPalette &palette);

} // namespace codewheel
