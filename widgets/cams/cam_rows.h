// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/appearance.h"

#include <QWidget>

// The measures that table and ruler share, so that their rows line up. Logical pixels.
namespace codewheel {

// 26, as high as a bit; large controls make it 39.
inline int camRowHeight(const QWidget &widget)
{
    return qRound(26 * controlFactor(widget));
}

// Header of the table, axis of the ruler.
inline int camAxisHeight(const QWidget &widget)
{
    return widget.fontMetrics().height() + 12;
}

} // namespace codewheel
