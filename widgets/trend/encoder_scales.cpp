// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/encoder_scales.h"

namespace codewheel {

// What is not known any more, as in parameterization, stays as it was.
bool EncoderScales::look()
{
    const auto before = m_known;
    for (const Place place : m_buses.places()) {
        const EncoderSession *encoder = m_buses.encoder(place);
        if (encoder == nullptr)
            continue;
        StepScale &now = m_known[place].now;
        const StepScale scale = stepScale(*encoder);
        if (scale.isKnown() || scale.isRod != now.isRod)
            now = scale;
    }
    for (auto &[place, known] : m_known)
        known.since = m_histories.scales(place);
    return m_known != before;
}

const EncoderScales::Known &EncoderScales::known(Place place) const
{
    static const Known nothing;
    const auto found = m_known.find(place);
    return found == m_known.end() ? nothing : found->second;
}

bool EncoderScales::asksForTravel(Place place) const
{
    return !isRod(place) && stepsPerTurn(place).has_value();
}

std::optional<double> EncoderScales::stepsPerTurn(Place place) const
{
    return known(place).newest().stepsPerTurn;
}

std::optional<double> EncoderScales::perStep(Place place, TrackUnit unit) const
{
    return perStep(place, unit, known(place).newest());
}

std::optional<double> EncoderScales::perStep(Place place, TrackUnit unit, const StepScale &its) const
{
    const auto ofTurn = [&](std::optional<double> turn) {
        return turn && its.stepsPerTurn ? std::optional(*turn / *its.stepsPerTurn) : std::nullopt;
    };
    switch (unit) {
    case TrackUnit::steps:
        return 1;
    case TrackUnit::turns:
        return ofTurn(1);
    case TrackUnit::degrees:
        return ofTurn(360);
    case TrackUnit::millimetres:
        return its.isRod ? its.millimetresPerStep : ofTurn(m_tracks.travel(place));
    }
    return {};
}

// What had no such unit then is shown as if it had been as it was next.
std::vector<TrackScale::Earlier> EncoderScales::earlier(Place place, TrackUnit unit) const
{
    std::vector<TrackScale::Earlier> all;
    const std::vector<ScaleSince> &since = known(place).since;
    for (std::size_t i = 0; i + 1 < since.size(); ++i) {
        const auto then = perStep(place, unit, since[i].scale);
        if (then && then != perStep(place, unit, since[i + 1].scale))
            all.push_back({since[i + 1].from, *then});
    }
    return all;
}

TrackScale EncoderScales::of(const TrendTracks::Shown &shown) const
{
    const Place place = shown.track.place;
    if (const auto scale = perStep(place, shown.unit))
        return {shown.unit, *scale, earlier(place, shown.unit)};
    return {};
}

std::optional<TrackScale> EncoderScales::turns(Place place) const
{
    if (!has(place, TrackUnit::turns))
        return {};
    return of({.track = {place, Channel::position, {}}, .unit = TrackUnit::turns});
}

} // namespace codewheel
