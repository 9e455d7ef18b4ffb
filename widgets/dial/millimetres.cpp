// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/millimetres.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace codewheel {
namespace {

constexpr int mostDigits = 6;
constexpr int usualDigits = 3; // of a resolution

// Digits after the point until the number is told to a ten-thousandth of itself.
int digitsFor(double number)
{
    for (int digits = usualDigits; digits < mostDigits; ++digits) {
        const double scale = std::pow(10, digits);
        if (std::abs(std::round(number * scale) / scale - number) <= number * 1e-4)
            return digits;
    }
    return mostDigits;
}

} // namespace

QString millimetres(double length, double millimetresPerStep)
{
    const double digits = millimetresPerStep > 0 ? std::ceil(-std::log10(millimetresPerStep) - 1e-9) : 0;
    return QLocale().toString(length, 'f', std::clamp(static_cast<int>(digits), 0, mostDigits));
}

QString resolution(double millimetresPerStep)
{
    return QCoreApplication::translate("Millimetres", "%1 mm per step")
        .arg(QLocale().toString(millimetresPerStep, 'f', digitsFor(millimetresPerStep)));
}

} // namespace codewheel
