// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/encoder_scales.h"

#include "catalog/device_description.h"
#include "catalog/protocol_rules.h"
#include "jobs/position_scale.h"
#include "vocabulary/rod_scale.h"

namespace codewheel {

// What is not known any more, as in parameterization, stays as it was.
bool EncoderScales::look()
{
    const auto before = m_known;
    for (const Place place : m_buses.places()) {
        const EncoderSession *encoder = m_buses.encoder(place);
        if (encoder == nullptr)
            continue;
        Known &known = m_known[place];
        known.isRod = codewheel::isRod(encoder->device());
        if (known.isRod) {
            if (const auto scale = rodScale(*encoder))
                known.millimetresPerStep = scale->millimetres(1'000'000) / 1e6;
            continue;
        }
        const auto scale = speedScaleOf(
            encoder->device(), [encoder](Parameter parameter) { return knownNumber(*encoder, parameter); });
        if (scale)
            known.stepsPerTurn = scale->stepsPerTurn;
    }
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
    return !known(place).isRod && known(place).stepsPerTurn.has_value();
}

std::optional<double> EncoderScales::stepsPerTurn(Place place) const
{
    return known(place).stepsPerTurn;
}

std::optional<double> EncoderScales::perStep(Place place, TrackUnit unit) const
{
    const Known &its = known(place);
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

TrackScale EncoderScales::of(const TrendTracks::Shown &shown) const
{
    if (const auto scale = perStep(shown.track.place, shown.unit))
        return {shown.unit, *scale};
    return {};
}

} // namespace codewheel
