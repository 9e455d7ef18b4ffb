// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/histories.h"
#include "widgets/trend/trend_tracks.h"

namespace codewheel {

// In which units the positions of an encoder can be shown, by what is known of it; as last known of one that
// is not connected.
class EncoderScales
{
public:
    // All outlive it.
    EncoderScales(const Buses &buses, const Histories &histories, const TrendTracks &tracks)
        : m_buses(buses)
        , m_histories(histories)
        , m_tracks(tracks)
    {}

    bool look(); // at what is known now; whether it differs
    // In steps where the unit cannot be had; otherwise each part of the time by what a step was then.
    TrackScale of(const TrendTracks::Shown &shown) const;
    bool has(Place place, TrackUnit unit) const { return perStep(place, unit).has_value(); }
    // On a shaft the way per turn is told by the user.
    bool asksForTravel(Place place) const;
    bool isRod(Place place) const { return known(place).newest().isRod; }
    std::optional<double> stepsPerTurn(Place place) const; // as known last
    std::optional<TrackScale> turns(Place place) const;    // nothing: it has none, or they are not known

private:
    struct Known
    {
        StepScale now{};                 // of a recording: at the moment that is played
        std::vector<ScaleSince> since{}; // empty: as now

        const StepScale &newest() const { return now.isKnown() && !since.empty() ? since.back().scale : now; }

        friend bool operator==(const Known &, const Known &) = default;
    };

    std::optional<double> perStep(Place place, TrackUnit unit) const;
    std::optional<double> perStep(Place place, TrackUnit unit, const StepScale &its) const;
    std::vector<TrackScale::Earlier> earlier(Place place, TrackUnit unit) const;
    const Known &known(Place place) const;

    const Buses &m_buses;
    const Histories &m_histories;
    const TrendTracks &m_tracks;
    std::map<Place, Known> m_known;
};

} // namespace codewheel
