// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/rod_reading.h"

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"
#include "widgets/dial/rod_dial.h"
#include "widgets/dial/state_note.h"
#include "widgets/models/age_text.h"

namespace codewheel {
namespace {

QString noteOfKnown(const RodState &known, const QString &missing)
{
    if (!missing.isEmpty())
        return RodDial::tr("Not known: %1.").arg(missing);
    return known.scale ? QString() : RodDial::tr("mm unknown: set the rod length from its label.");
}

void makeOld(RodState &state, const EncoderSession &encoder)
{
    const bool isRecorded = encoder.freshness().isOfRecording();
    const StateNote note =
        isRecorded ? noteOfRecording(encoder, {state.note, state.role}) : noteOfAge(encoder);
    if (!isRecorded)
        state.stepsPerSecond.reset();
    state.isLastKnown = true;
    state.age = ageText(encoder);
    state.note = note.sentence;
    state.role = note.role;
}

RodState rodStateOf(const EncoderSession &encoder, const RodState &known, const QString &missing)
{
    const Reading &reading = encoder.latest();
    RodState state = known;
    state.position = reading.position;
    if (reading.state == EncoderState::operation || reading.showsPosition()) {
        state.stepsPerSecond = reading.stepsPerSecond;
        state.note = noteOfKnown(known, missing);
        state.role = state.note.isEmpty() ? Role::running : Role::attention;
        if (state.note.isEmpty() && !magnetPlace(state))
            state.note =
                RodDial::tr("The position was set by a preset: where the magnet is on the rod is not known.");
        return state;
    }
    const StateNote note = noteOfState(encoder.device(), reading);
    state.isLastKnown = true;
    state.note = note.sentence;
    state.role = note.role;
    return state;
}

} // namespace

RodState knownOfRod(const EncoderSession &encoder)
{
    return rodWith(encoder.device(), [&](Parameter parameter) { return knownNumber(encoder, parameter); });
}

RodState rodWith(const DeviceDescription &device, const ValueOf &valueOf)
{
    RodState rod;
    rod.length = valueOf(Parameter::measuringLength);
    rod.scale = rodScale(rod.length, valueOf(Parameter::rodLength));
    const ParameterDescription *direction = device.find(Parameter::direction);
    if (const auto value = valueOf(Parameter::direction); value && direction != nullptr)
        if (const Choice *choice = direction->findChoice(*value))
            rod.countsUpToTheEnd = choice->key == QStringLiteral("increasing");
    return rod;
}

RodState rodReading(const EncoderSession &encoder, const RodState &known, const QString &missing)
{
    RodState state = rodStateOf(encoder, known, missing);
    if (encoder.freshness().isOfRecording() || encoder.freshness().isOld())
        makeOld(state, encoder);
    return state;
}

} // namespace codewheel
