// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/recording/export_wish.h"

#include "catalog/catalog.h"
#include "cli/call/texts.h"
#include "jobs/position_scale.h"
#include "project/project.h"
#include "vocabulary/rod_scale.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr double degreesOfTurn = 360;
constexpr double millimetresOfMetre = 1'000;

const RecordingFacts::Encoder *encoderIn(const RecordingFacts &facts, Place place)
{
    const auto found = std::ranges::find(facts.encoders, place, &RecordingFacts::Encoder::place);
    return found == facts.encoders.end() ? nullptr : &*found;
}

bool hasTrack(const RecordingFacts &facts, const Track &track)
{
    const RecordingFacts::Encoder *encoder = encoderIn(facts, track.place);
    return encoder != nullptr && std::ranges::count(encoder->channels, track.channel) > 0;
}

std::vector<Track> allTracks(const RecordingFacts &facts)
{
    std::vector<Track> tracks;
    for (const RecordingFacts::Encoder &encoder : facts.encoders)
        for (const Channel channel : encoder.channels)
            tracks.push_back({encoder.place, channel, {}});
    return tracks;
}

Checked<std::vector<Track>> tracksMeant(const Arguments &arguments, const RecordingFacts &facts)
{
    const auto typed = arguments.value("--tracks");
    if (!typed)
        return allTracks(facts);
    std::vector<Track> tracks;
    for (const QString &text : typed->split(u',')) {
        const auto track = Track::parse(text.trimmed());
        if (!track || !hasTrack(facts, *track))
            return badInput("noSuchTrack",
                            CommandLine::tr("The recording has no \"%1\". It has: %2. One bit is 1.0/in.25."),
                            {text, listed(allTracks(facts), &Track::key)});
        if (std::ranges::count(tracks, *track) == 0)
            tracks.push_back(*track);
    }
    return tracks;
}

// As its description says, with what its label said of it when it was recorded.
std::optional<double> stepsPerTurnOf(const Call &call, const RecordedDevice &recorded)
{
    const DeviceDescription *described = call.catalog.find(recorded.key);
    if (described == nullptr)
        return std::nullopt;
    DeviceDescription device = *described;
    device.physicalTurns = recorded.turns;
    device.physicalStepsPerTurn = recorded.stepsPerTurn;
    const auto scale =
        speedScaleOf(device, [&](Parameter parameter) { return valueOf(recorded.known, parameter); });
    return scale ? std::optional(scale->stepsPerTurn) : std::nullopt;
}

std::optional<double> millimetresPerStep(const RecordedDevice &device)
{
    const auto scale = rodScale(valueOf(device.known, Parameter::measuringLength),
                                valueOf(device.known, Parameter::rodLength));
    return scale ? std::optional(scale->millimetres(1'000'000) / 1e6) : std::nullopt;
}

std::optional<double> perStep(const Call &call, const RecordedDevice &device, TrackUnit unit,
                              std::optional<double> millimetresPerTurn)
{
    if (unit == TrackUnit::millimetres)
        if (const auto rod = millimetresPerStep(device))
            return rod;
    const auto steps = stepsPerTurnOf(call, device);
    if (!steps)
        return std::nullopt;
    switch (unit) {
    case TrackUnit::turns:
        return 1 / *steps;
    case TrackUnit::degrees:
        return degreesOfTurn / *steps;
    case TrackUnit::millimetres:
        return millimetresPerTurn ? std::optional(*millimetresPerTurn / *steps) : std::nullopt;
    case TrackUnit::steps:
        break;
    }
    return 1;
}

// What does not follow from what was known then is scaled as what was known next.
std::vector<TrackScale::Earlier> earlierScales(const Call &call, const RecordingFacts::Encoder &encoder,
                                               TrackUnit unit, std::optional<double> millimetresPerTurn)
{
    std::vector<TrackScale::Earlier> earlier;
    std::optional<double> before;
    for (const auto &[since, device] : encoder.described) {
        const auto now = perStep(call, device, unit, millimetresPerTurn);
        if (before && now && *before != *now)
            earlier.push_back({since, *before});
        before = now ? now : before;
    }
    return earlier;
}

Checked<std::optional<double>> millimetresPerTurnMeant(const Arguments &arguments)
{
    const auto text = arguments.value("--mm-per-turn");
    if (!text)
        return std::nullopt;
    bool isNumber = false;
    const double number = text->toDouble(&isNumber);
    if (isNumber && number > 0 && number <= millimetresOfMetre * millimetresOfMetre)
        return number;
    return badInput("notANumber",
                    CommandLine::tr("\"%1\" is no way per turn. Write millimetres with a point: 31.4."),
                    {*text});
}

Checked<TrackUnit> unitMeant(const Arguments &arguments)
{
    const auto text = arguments.value("--unit");
    if (!text)
        return TrackUnit::steps;
    if (const auto unit = trackUnit(*text))
        return *unit;
    return badInput("optionNotAllowed", CommandLine::tr("%1 cannot be \"%2\". There are: %3."),
                    {QStringLiteral("--unit"), *text,
                     listed(trackUnits, [](TrackUnit unit) { return QString(unitKey(unit)); })});
}

bool isScaled(Channel channel)
{
    return channel == Channel::position || channel == Channel::speed;
}

tl::unexpected<Complaint> aboutScale(Place place, TrackUnit unit)
{
    if (unit == TrackUnit::millimetres)
        return badInput("unitNotKnown",
                        CommandLine::tr("How much of a millimetre a step of %1 is does not follow from the "
                                        "recording. For an encoder on a shaft --mm-per-turn tells it."),
                        {place.key()});
    return badInput(
        "unitNotKnown",
        CommandLine::tr("How many steps a turn of %1 has does not follow from the recording. Leave "
                        "--unit out, or name other tracks with --tracks."),
        {place.key()});
}

std::vector<ValuesSince> knownOf(const RecordingFacts::Encoder &encoder)
{
    std::vector<ValuesSince> known;
    for (const auto &[since, device] : encoder.described)
        known.push_back({since, device.known});
    return known;
}

QString stationOf(const Call &call, Place place)
{
    const ProjectDevice *planned = call.project != nullptr ? findDevice(*call.project, place) : nullptr;
    return planned != nullptr ? planned->station : QString();
}

} // namespace

Checked<TrendExtract> extractMeant(const Call &call, const RecordingFacts &facts)
{
    const auto unit = unitMeant(call.arguments);
    const auto perTurn = millimetresPerTurnMeant(call.arguments);
    if (!unit || !perTurn)
        return tl::unexpected(unit ? perTurn.error() : unit.error());
    const auto tracks = tracksMeant(call.arguments, facts);
    if (!tracks)
        return tl::unexpected(tracks.error());
    const auto span = spanMeant(call.arguments, facts);
    if (!span)
        return tl::unexpected(span.error());
    TrendExtract extract{.columns = {}, .span = *span};
    for (const Track &track : *tracks) {
        TrendColumn column{.track = track, .name = stationOf(call, track.place)};
        if (*unit != TrackUnit::steps && isScaled(track.channel)) {
            const RecordingFacts::Encoder &encoder = *encoderIn(facts, track.place);
            const auto scale = perStep(call, encoder.device, *unit, *perTurn);
            if (!scale)
                return aboutScale(track.place, *unit);
            column.scale = {*unit, *scale, earlierScales(call, encoder, *unit, *perTurn)};
        }
        extract.columns.push_back(std::move(column));
    }
    return extract;
}

std::vector<TrendEncoder> encodersOf(const Call &call, const RecordingFacts &facts,
                                     const TrendExtract &extract)
{
    std::vector<TrendEncoder> encoders;
    for (const RecordingFacts::Encoder &encoder : facts.encoders) {
        const auto isOf = [&](const TrendColumn &column) { return column.track.place == encoder.place; };
        if (std::ranges::none_of(extract.columns, isOf))
            continue;
        const auto bus = std::ranges::find(facts.buses, encoder.place.bus, &RecordedBus::bus);
        encoders.push_back({.place = encoder.place,
                            .station = stationOf(call, encoder.place),
                            .busName = bus == facts.buses.end() ? QString() : bus->name,
                            .device = encoder.device.key,
                            .deviceName = encoder.device.name,
                            .stepsPerTurn = stepsPerTurnOf(call, encoder.device),
                            .values = recordedValues(knownOf(encoder))});
    }
    return encoders;
}

} // namespace codewheel
