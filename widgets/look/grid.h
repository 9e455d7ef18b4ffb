// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The grid for all layouts, in logical pixels.
namespace codewheel::grid {

inline constexpr int unit = 4;
inline constexpr int margin = 2 * unit;
inline constexpr int groupGap = 2 * unit; // between groups of bits, between a label and its field
inline constexpr int smallIcon = 16;
inline constexpr int largeIcon = 24;

} // namespace codewheel::grid
