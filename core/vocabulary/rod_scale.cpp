// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/rod_scale.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace codewheel {
namespace {

constexpr int mostDecimals = 3;
constexpr double micrometresPerMillimetre = 1'000;

} // namespace

double millimetresOf(std::int64_t micrometres)
{
    return static_cast<double>(micrometres) / micrometresPerMillimetre;
}

std::int64_t micrometresOf(double millimetres)
{
    return std::llround(millimetres * micrometresPerMillimetre);
}

double RodScale::millimetres(std::int64_t position) const
{
    return static_cast<double>(position) * static_cast<double>(micrometres) / static_cast<double>(steps) /
           micrometresPerMillimetre;
}

QString RodScale::text(std::int64_t position) const
{
    int decimals = 0;
    for (std::int64_t part = 1'000; decimals < mostDecimals && part * steps > micrometres; part /= 10)
        ++decimals;
    return QCoreApplication::translate("RodScale", "%1 mm")
        .arg(QLocale().toString(millimetres(position), 'f', decimals));
}

std::optional<RodScale> rodScale(std::optional<std::int64_t> measuringLength,
                                 std::optional<std::int64_t> rodLength)
{
    if (!measuringLength || !rodLength || *measuringLength <= 0 || *rodLength <= 0)
        return std::nullopt;
    return RodScale{*measuringLength, *rodLength};
}

std::optional<RodScale> rodScale(const EncoderSession &encoder)
{
    return rodScale(knownNumber(encoder, Parameter::measuringLength),
                    knownNumber(encoder, Parameter::rodLength));
}

} // namespace codewheel
