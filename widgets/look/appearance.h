// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/roles.h"

class QApplication;
class QWidget;

namespace codewheel {

enum class Scheme : std::uint8_t { system, light, dark };

// What the user chooses under View. Qt 6.4 reports neither a dark desktop nor a wish for less motion, so both
// are our own settings.
struct Appearance
{
    Scheme scheme = Scheme::system;
    bool largeControls = false; // for gloves: clickable controls are 1.5 times as large
    bool lessMotion = false;

    friend bool operator==(const Appearance &, const Appearance &) = default;
};

// "System" follows the lightness of the desktop's palette.
Shade shadeFor(Scheme scheme, const QPalette &desktop);

// Gives the application the Fusion style with our palette; may be called again at any time, even with windows
// open.
void applyAppearance(QApplication &application, const Appearance &appearance);

// 1.5 with large controls, else 1: for widgets that paint their own controls. Ask again on StyleChange.
double controlFactor(const QWidget &widget);

} // namespace codewheel
