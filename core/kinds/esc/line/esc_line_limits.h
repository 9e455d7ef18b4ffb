// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_settings.h"

// The limits of the settings of a serial line: the one table for the command line, the project's file and the
// form in the window. The manual states only the shortest interval, the rest is ours.
namespace codewheel::line_limits {

// Both ends included.
struct Limits
{
    int least = 0;
    int most = 0;

    constexpr bool hold(int value) const { return value >= least && value <= most; }
};

inline constexpr Limits baudRate{50, 10'000'000}; // Bd
inline constexpr Limits timeOut{1, 60'000};       // ms
inline constexpr Limits retries{0, 20};
inline constexpr Limits quietAfterWrite{0, 60'000}; // ms
inline constexpr Limits pollInterval{
    static_cast<int>(EscLineSettings::shortestInterval / std::chrono::milliseconds(1)), 60'000}; // ms
inline constexpr Limits topSpeed{1, 100'000};                                                    // 1/min
inline constexpr Limits fractionBits{esc::fewestFractionBits, esc::mostFractionBits};

} // namespace codewheel::line_limits
