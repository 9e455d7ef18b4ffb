// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>

#include <array>

namespace codewheel {

// How much room a window has for its panels. Each size has its own arrangement.
enum class WindowSize {
    narrow, // one column beside the middle
    low,    // a column on each side, with few panels one above the other
    usual,
    wide, // panels that are tabbed at the bottom are side by side
};
inline constexpr std::array allWindowSizes{WindowSize::narrow, WindowSize::low, WindowSize::usual,
                                           WindowSize::wide};

inline WindowSize windowSizeOf(QSize logical)
{
    constexpr int forTwoColumns = 1200;
    constexpr int forWideColumns = 1700;
    constexpr int forFullColumns = 720; // high
    if (logical.width() < forTwoColumns)
        return WindowSize::narrow;
    if (logical.height() < forFullColumns)
        return WindowSize::low;
    return logical.width() < forWideColumns ? WindowSize::usual : WindowSize::wide;
}

} // namespace codewheel
