// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "widgets/trend/trend_tracks.h"

namespace codewheel {

// In which units the positions of an encoder can be shown, by what is known of it; as last known of one that
// is not connected.
class EncoderScales
{
public:
    // Both outlive it.
    EncoderScales(const Buses &buses, const TrendTracks &tracks)
        : m_buses(buses)
        , m_tracks(tracks)
    {}

    bool look(); // at what is known now; whether it differs
    // In steps where the unit cannot be had.
    TrackScale of(const TrendTracks::Shown &shown) const;
    bool has(Place place, TrackUnit unit) const { return perStep(place, unit).has_value(); }
    // On a shaft the way per turn is told by the user.
    bool asksForTravel(Place place) const;
    bool isRod(Place place) const { return known(place).isRod; }
    std::optional<double> stepsPerTurn(Place place) const;

private:
    struct Known
    {
        bool isRod = false;
        std::optional<double> stepsPerTurn{};
        std::optional<double> millimetresPerStep{}; // of a rod

        friend bool operator==(const Known &, const Known &) = default;
    };

    std::optional<double> perStep(Place place, TrackUnit unit) const;
    const Known &known(Place place) const;

    const Buses &m_buses;
    const TrendTracks &m_tracks;
    std::map<Place, Known> m_known;
};

} // namespace codewheel
