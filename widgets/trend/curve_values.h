// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/trend/trend_scene.h"

class QLocale;

namespace codewheel {

// What a curve was at the cursors and between them, in words. Nothing is shown where nothing is known.
class CurveValues
{
public:
    // `stepsPerTurn`: of the encoder, where it is known.
    CurveValues(const TrendCurve &curve, std::optional<double> stepsPerTurn, const QLocale &locale)
        : m_curve(curve)
        , m_stepsPerTurn(stepsPerTurn)
        , m_locale(locale)
    {}

    QString now() const;
    QString at(Instant at) const;
    QString difference(const TimeSpan &span) const;          // in its unit
    QString differenceInDegrees(const TimeSpan &span) const; // of a position on a shaft
    QString rate(const TimeSpan &span) const;                // rpm, or in its unit per second

    // In its unit.
    QString text(double value) const;
    QString text(const std::optional<Sample> &sample) const;
    // Of numbers, not of words and bits: with one digit more than single values have.
    QString averageText(double value) const;

private:
    std::optional<double> steps(const TimeSpan &span) const;
    double resolution() const; // in its unit: of a step, or of one per second

    const TrendCurve &m_curve;
    std::optional<double> m_stepsPerTurn;
    const QLocale &m_locale;
};

} // namespace codewheel
