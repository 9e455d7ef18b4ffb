// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/histories.h"
#include "widgets/trend/encoder_scales.h"
#include "widgets/trend/trend_scene.h"

#include <functional>

class QPalette;

namespace codewheel {

// Puts together what a trend shows: curves by encoder and unit in lanes, each with an axis that fits what is
// seen of it, or that was fixed.
class SceneMaker
{
public:
    // All outlive it. `station`: of an encoder; empty where it has none.
    SceneMaker(const Histories &histories, const TrendTracks &tracks, const EncoderScales &scales,
               std::function<QString(Place)> station)
        : m_histories(histories)
        , m_tracks(tracks)
        , m_scales(scales)
        , m_station(std::move(station))
    {}

    TrendScene make(const TimeSpan &span, const QPalette &palette) const;
    // In lanes of the scene made last.
    void fixAxis(const TrendLane &lane, double low, double high);
    void freeAxes() { m_fixed.clear(); }

private:
    struct Axis
    {
        Track first; // of the curves on it
        TrackUnit unit = TrackUnit::steps;

        friend bool operator<(const Axis &one, const Axis &other)
        {
            return std::tie(one.first, one.unit) < std::tie(other.first, other.unit);
        }
    };

    TrendCurve curve(const TrendTracks::Shown &shown) const; // without its colour
    static Axis axisOf(const TrendLane &lane);
    void fitAxis(TrendLane &lane, const TimeSpan &span) const;
    QString nameOf(const TrendCurve &curve) const;

    const Histories &m_histories;
    const TrendTracks &m_tracks;
    const EncoderScales &m_scales;
    std::function<QString(Place)> m_station;
    std::map<Axis, std::pair<double, double>> m_fixed;
};

} // namespace codewheel
