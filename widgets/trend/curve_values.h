// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/trend/trend_scene.h"

class QLocale;

namespace codewheel {

// What a curve was at the cursors and between them, in words. Nothing is shown where nothing is known.
class CurveValues
{
public:
    // `turns`: how much of a turn a step is, where that is known.
    CurveValues(const TrendCurve &curve, std::optional<TrackScale> turns, const QLocale &locale)
        : m_curve(curve)
        , m_turns(std::move(turns))
        , m_locale(locale)
    {}

    QString now() const;
    QString at(Instant at) const;
    QString difference(const TimeSpan &span) const;          // in its unit
    QString differenceInDegrees(const TimeSpan &span) const; // of a position on a shaft
    QString rate(const TimeSpan &span) const;                // rpm, or in its unit per second

    // In its unit.
    QString text(double value) const;
    QString text(const std::optional<Sample> &sample, Instant then) const;
    // Of numbers, not of words and bits: with one digit more than single values have.
    QString averageText(double value) const;

private:
    std::optional<double> way(const TimeSpan &span, const TrackScale &scale) const;
    double resolution() const; // in its unit: of a step, or of one per second

    const TrendCurve &m_curve;
    std::optional<TrackScale> m_turns;
    const QLocale &m_locale;
};

} // namespace codewheel
