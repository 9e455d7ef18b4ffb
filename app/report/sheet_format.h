// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

// A4 portrait, in dots. Fonts are sized in dots too, so that nothing depends on a screen or a printer.
namespace codewheel::sheet {

inline constexpr int dotsPerInch = 1200;

constexpr qreal mm(qreal millimetres)
{
    return millimetres / 25.4 * dotsPerInch;
}
constexpr qreal point(qreal points)
{
    return points / 72 * dotsPerInch;
}

inline constexpr QSizeF paper(mm(210), mm(297));
inline constexpr QRectF body(mm(18), mm(20), mm(177),
                             mm(256));     // 15 mm at the right, 18 for holes at the left
inline constexpr qreal headLine = mm(12);  // top of the line above the body
inline constexpr qreal footLine = mm(281); // and of the one below
inline constexpr qreal columnGap = mm(3);  // between columns of a table, as in html_style.h
inline constexpr qreal thinLine = mm(0.1);

} // namespace codewheel::sheet
