// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/shaft_state.h"

#include "catalog/device_description.h"
#include "catalog/protocol_rules.h"
#include "jobs/position_scale.h"
#include "widgets/dial/missing_values.h"
#include "widgets/dial/shaft_dial.h"
#include "widgets/dial/state_note.h"
#include "widgets/models/age_text.h"
#include "widgets/monitor/position_range.h"

namespace codewheel {
namespace {

struct Shown
{
    const EncoderSession &encoder;
    const std::optional<ShaftScale> &scale;
    const QString &missing;
};

bool countsClockwise(const EncoderSession &encoder)
{
    for (const Parameter parameter : {Parameter::direction, Parameter::coding}) {
        if (const auto known = encoder.known(parameter))
            return countsClockwise(encoder.device(), {parameter, known->value});
    }
    return true;
}

// The position of a K1 or K2 is the place on its code disc.
std::optional<ShaftScale> physicalScale(const EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    if (!positionRange(encoder))
        return std::nullopt;
    return ShaftScale{.stepsPerTurn = static_cast<double>(device.physicalStepsPerTurn),
                      .countsTurns = device.physicalTurns > 1};
}

// Its position and speed now are not known any more.
void makeOld(DialState &state, const EncoderSession &encoder)
{
    const StateNote note = noteOfAge(encoder);
    state.isLastKnown = true;
    state.age = ageText(encoder);
    state.velocity.reset();
    state.rpm.reset();
    state.note = note.sentence;
    state.role = note.role;
}

void makeRecorded(DialState &state, const EncoderSession &encoder)
{
    const StateNote note = noteOfRecording(encoder, {state.note, state.role});
    state.isLastKnown = true;
    state.age = ageText(encoder);
    state.note = note.sentence;
    state.role = note.role;
}

// What is missing, or that the position is not plain binary.
QString noteOf(const Shown &shown)
{
    const Reading &reading = shown.encoder.latest();
    if (!shown.missing.isEmpty())
        return ShaftDial::tr("Not known: %1. The disc needs it to turn.").arg(shown.missing);
    if (!shown.scale && onlyTellsPosition(shown.encoder.device()))
        return ShaftDial::tr("The steps per turn of this encoder are not described: the disc cannot turn.");
    if (reading.coding == PositionCoding::gray)
        return ShaftDial::tr("The position comes in Gray code.");
    if (reading.coding == PositionCoding::signedBinary)
        return ShaftDial::tr("The position is signed.");
    if (shown.scale && reading.mayMissTurns)
        return ShaftDial::tr(
            "No speed: positions come so seldom that the shaft may make a whole turn between two.");
    return {};
}

// The sense of rotation follows from the counting direction.
DialState turning(const EncoderSession &encoder, std::int64_t velocity)
{
    DialState state{.velocity = velocity, .note = whyNoPosition(encoder), .role = Role::running};
    if (encoder.known(Parameter::direction))
        state.rpm = static_cast<double>(countsClockwise(encoder) ? velocity : -velocity);
    return state;
}

DialState running(const Shown &shown)
{
    const Reading &reading = shown.encoder.latest();
    if (reading.velocity)
        return turning(shown.encoder, *reading.velocity);
    if (!reading.position)
        return {.note = whyNoPosition(shown.encoder), .role = Role::attention};
    DialState state{.position = *reading.position,
                    .note = noteOf(shown),
                    .role = shown.missing.isEmpty() ? Role::running : Role::attention};
    if (!shown.scale)
        return state;
    state.turnFraction = shown.scale->turnFraction(*reading.position);
    if (shown.scale->countsTurns)
        state.turn = static_cast<qint64>(std::floor(shown.scale->turns(*reading.position)));
    if (reading.stepsPerSecond)
        state.rpm =
            *reading.stepsPerSecond / shown.scale->stepsPerTurn * 60 * (shown.scale->clockwise ? 1 : -1);
    return state;
}

// One that is silent, cut off, or whose line was lost, shows its last position.
DialState stateOf(const Shown &shown)
{
    const Reading &reading = shown.encoder.latest();
    const bool isAway = reading.state == EncoderState::notSeen || reading.state == EncoderState::silent;
    if (reading.state == EncoderState::operation || reading.showsPosition() || (isAway && reading.position))
        return running(shown);
    const StateNote note = noteOfState(shown.encoder.device(), reading);
    return {.note = note.sentence, .role = note.role};
}

} // namespace

std::optional<ShaftScale> shaftScale(const EncoderSession &encoder)
{
    if (onlyTellsPosition(encoder.device()))
        return physicalScale(encoder);
    if (!missingOf(encoder, shaftValues).empty())
        return std::nullopt;
    const auto scale =
        speedScaleOf(encoder.device(), [&](Parameter parameter) { return knownNumber(encoder, parameter); });
    return scale ? std::optional(
                       ShaftScale{.stepsPerTurn = scale->stepsPerTurn, .clockwise = countsClockwise(encoder)})
                 : std::nullopt;
}

DialState shaftState(const EncoderSession &encoder, const std::optional<ShaftScale> &scale,
                     const QString &missing)
{
    DialState state = stateOf({encoder, scale, missing});
    if (encoder.freshness().isOfRecording())
        makeRecorded(state, encoder);
    else if (encoder.freshness().isOld())
        makeOld(state, encoder);
    return state;
}

} // namespace codewheel
