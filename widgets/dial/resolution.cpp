// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/resolution.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace codewheel {
namespace {

constexpr int mostDecimals = 6;
constexpr int usualDigits = 3; // of a resolution

// Digits after the point until the number is exact to a ten-thousandth.
int digitsFor(double number)
{
    for (int digits = usualDigits; digits < mostDecimals; ++digits) {
        const double scale = std::pow(10, digits);
        if (std::abs(std::round(number * scale) / scale - number) <= number * 1e-4)
            return digits;
    }
    return mostDecimals;
}

} // namespace

QString resolution(double mmPerStep)
{
    return QCoreApplication::translate("Resolution", "%1 mm per step")
        .arg(QLocale().toString(mmPerStep, 'f', digitsFor(mmPerStep)));
}

} // namespace codewheel
