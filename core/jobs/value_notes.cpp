// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/value_notes.h"

#include "catalog/total_range.h"
#include "jobs/protocol.h"
#include "jobs/values_to_write.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr auto noteKeys = std::to_array<TextOf<ValueNote::Id>>({
    {ValueNote::Id::revolutionsSetAlong, "revolutionsSetAlong"},
    {ValueNote::Id::rangeJumps, "rangeJumps"},
    {ValueNote::Id::revolutionsJump, "revolutionsJump"},
    {ValueNote::Id::fractionJumps, "fractionJumps"},
    {ValueNote::Id::presetNeeded, "presetNeeded"},
    {ValueNote::Id::scalingOff, "scalingOff"},
    {ValueNote::Id::scalingUnknown, "scalingUnknown"},
    {ValueNote::Id::offsetLeftOut, "offsetLeftOut"},
    {ValueNote::Id::positionShifts, "positionShifts"},
    {ValueNote::Id::positionShiftsAbout, "positionShiftsAbout"},
    {ValueNote::Id::presetUsedUp, "presetUsedUp"},
    {ValueNote::Id::presetMayBeUsedUp, "presetMayBeUsedUp"},
});

void noteWhatIsSetAlong(const DeviceDescription &device, const ParameterValues &written,
                        const ParameterValues &known, std::vector<ValueNote> &notes)
{
    for (const ParameterValue &along : protocolOf(device).setAlong(written, known)) {
        const auto now = valueOf(known, along.parameter);
        notes.push_back(
            {ValueNote::Id::revolutionsSetAlong,
             {argumentOf(along.value), now ? RefusalArgument(*now) : RefusalArgument(QString())}});
    }
}

bool changesScale(const ParameterValue &value)
{
    return isOfScaling(value.parameter) || value.parameter == Parameter::scaling;
}

// Where the position jumps does not depend on the direction, so that need not be known. Steps are written to
// act, so the encoder is taken to scale its position unless it is known not to.
ParameterValues withAssumed(const DeviceDescription &device, ParameterValues known)
{
    const auto assume = [&](Parameter parameter, std::int64_t ParameterDescription::*value) {
        if (const ParameterDescription *found = device.find(parameter); found && !valueOf(known, parameter))
            known.push_back({parameter, found->*value});
    };
    assume(Parameter::direction, &ParameterDescription::minimum);
    assume(Parameter::coding, &ParameterDescription::minimum);
    assume(Parameter::scaling, &ParameterDescription::maximum);
    return known;
}

ScalingState scalingAfter(const DeviceDescription &device, const ParameterValues &written,
                          const ParameterValues &known)
{
    return scalingState(device, protocolOf(device).valueAfter(Parameter::scaling, written, known));
}

bool staysUnscaled(const DeviceDescription &device, const ParameterValues &written,
                   const ParameterValues &known)
{
    return scalingAfter(device, {}, known) == ScalingState::off &&
           scalingAfter(device, written, known) == ScalingState::off;
}

// With scaling off, the position has all its steps whatever is written.
std::optional<ValueNote> jumpAfter(const DeviceDescription &device, const ParameterValues &written,
                                   const ParameterValues &known)
{
    if (std::ranges::none_of(written, changesScale) ||
        scalingAfter(device, written, known) == ScalingState::off)
        return std::nullopt;
    if (const auto scale = scaleAfter(device, written, withAssumed(device, known)))
        return jumpNote(device, *scale);
    const ParameterDescription *range = device.find(Parameter::measuringRange);
    const auto turns = valueOf(written, Parameter::measuringRange);
    if (range == nullptr || range->unit != Unit::revolutions || !turns || *turns < 1 ||
        device.physicalTurns % *turns == 0)
        return std::nullopt;
    return ValueNote{ValueNote::Id::rangeJumps, {*turns, std::int64_t{device.physicalTurns}, QString()}};
}

// The zero offset is kept when the scaling changes, and belongs to the old scale (spec: arithmetic, NPV).
bool needsPreset(const DeviceDescription &device, const ParameterValues &written,
                 const ParameterValues &known)
{
    const auto offset = protocolOf(device).presetOffset();
    return device.capabilities.presets && offset && valueOf(known, *offset) != 0 &&
           !staysUnscaled(device, written, known) &&
           std::ranges::any_of(written, [&](const ParameterValue &value) {
               return changesScale(value) && valueOf(known, value.parameter) != value.value;
           });
}

QString jumpPattern(ValueNote::Id id)
{
    if (id == ValueNote::Id::fractionJumps)
        return QCoreApplication::translate("ValueNotes",
                                           "%1 steps in %2 revolutions give no whole number of steps over %3 "
                                           "turns: the position jumps by %5 steps after turn %4.");
    if (id == ValueNote::Id::revolutionsJump)
        return QCoreApplication::translate(
            "ValueNotes", "The %1 revolutions do not divide the %2 turns of the encoder: the "
                          "position jumps by %3 steps after turn %2.");
    return QCoreApplication::translate("ValueNotes",
                                       "The measuring range of %1 turns does not divide the %2 turns of the "
                                       "encoder: the position jumps by %3 steps after turn %2.");
}

QString pattern(const ValueNote &note)
{
    const bool isUntold = !note.arguments.empty() && note.arguments.back() == RefusalArgument(QString());
    switch (note.id) {
    case ValueNote::Id::revolutionsSetAlong:
        return isUntold ? QCoreApplication::translate("ValueNotes",
                                                      "With the steps, the encoder sets its revolutions to "
                                                      "%1. To have others, write them along with the steps.")
                        : QCoreApplication::translate(
                              "ValueNotes", "With the steps, the encoder sets its revolutions to %1: now "
                                            "they are %2. To keep them, write them along with the steps.");
    case ValueNote::Id::rangeJumps:
        if (isUntold)
            return QCoreApplication::translate("ValueNotes",
                                               "The measuring range of %1 turns does not divide the %2 turns "
                                               "of the encoder: the position jumps after turn %2.");
        break;
    case ValueNote::Id::fractionJumps:
        if (note.arguments.back() == RefusalArgument(std::int64_t{0}))
            return QCoreApplication::translate(
                "ValueNotes", "%1 steps in %2 revolutions give no whole number of steps over "
                              "%3 turns: the position jumps by a fraction of a step after "
                              "turn %4.");
        break;
    case ValueNote::Id::revolutionsJump:
        break;
    case ValueNote::Id::presetNeeded:
        return QCoreApplication::translate("ValueNotes",
                                           "With another scaling the position tells another place: set it to "
                                           "the preset again afterwards.");
    case ValueNote::Id::scalingOff:
        return QCoreApplication::translate("ValueNotes",
                                           "Scaling is off: the encoder keeps the values that scale its "
                                           "position, but counts its own steps until scaling is on.");
    case ValueNote::Id::scalingUnknown:
        return QCoreApplication::translate("ValueNotes",
                                           "It is not known whether scaling is on: while it is off, the "
                                           "encoder keeps the values that scale its position, but counts its "
                                           "own steps.");
    case ValueNote::Id::offsetLeftOut:
        return QCoreApplication::translate("ValueNotes",
                                           "Setting the position makes a new zero offset: the wanted one, "
                                           "%1, is left out.");
    case ValueNote::Id::positionShifts:
        return isUntold
                   ? QCoreApplication::translate("ValueNotes",
                                                 "This shifts the position, by how much is not known.")
                   : QCoreApplication::translate("ValueNotes", "This shifts the position: now %1, then %2.");
    case ValueNote::Id::positionShiftsAbout:
        return QCoreApplication::translate("ValueNotes", "This shifts the position: now %1, then about %2.");
    case ValueNote::Id::presetUsedUp:
        return QCoreApplication::translate("ValueNotes",
                                           "A preset acts once, and the one in the encoder is used up: it is "
                                           "written again, so that the position can be set to it.");
    case ValueNote::Id::presetMayBeUsedUp:
        return QCoreApplication::translate("ValueNotes",
                                           "A preset acts once. Whether the one in the encoder is used up is "
                                           "read first; if it is, it is written again.");
    }
    return jumpPattern(note.id);
}

} // namespace

ParameterValues valuesOf(const std::vector<Known> &known)
{
    ParameterValues values;
    for (const Known &one : known)
        values.push_back({one.parameter, one.value});
    return values;
}

bool isOfScaling(Parameter parameter)
{
    static constexpr std::array scaling{Parameter::steps, Parameter::revolutions, Parameter::measuringRange,
                                        Parameter::scalingFactor};
    return std::ranges::find(scaling, parameter) != scaling.end();
}

std::optional<ValueNote> scalingNote(const DeviceDescription &device, const ParameterValues &written,
                                     const ParameterValues &known)
{
    const ScalingState state = scalingAfter(device, written, known);
    if (state == ScalingState::on || std::ranges::none_of(written, isOfScaling, &ParameterValue::parameter))
        return std::nullopt;
    return ValueNote{state == ScalingState::off ? ValueNote::Id::scalingOff : ValueNote::Id::scalingUnknown,
                     {}};
}

std::optional<ValueNote> scalingNote(const EncoderSession &encoder, const ParameterValues &written)
{
    return scalingNote(encoder.device(), written, valuesOf(allKnown(encoder)));
}

std::optional<ValueNote> jumpNote(const DeviceDescription &device, const PositionScale &scale)
{
    const std::int64_t jump = jumpAtWrap(scale);
    switch (wrapJump(scale)) {
    case WrapJump::none:
        break;
    case WrapJump::rangeDoesNotDivideTurns:
        return ValueNote{tellsItsRange(device) ? ValueNote::Id::revolutionsJump : ValueNote::Id::rangeJumps,
                         {scale.turns, scale.physicalTurns, jump}};
    case WrapJump::totalIsNotWhole:
        return ValueNote{ValueNote::Id::fractionJumps,
                         {scale.steps, scale.revolutions, scale.turns, scale.physicalTurns, jump}};
    }
    return std::nullopt;
}

std::vector<ValueNote> valueNotes(const DeviceDescription &device, const ParameterValues &written,
                                  const ParameterValues &known, PositionIsSet set)
{
    std::vector<ValueNote> notes;
    if (const auto unscaled = scalingNote(device, written, known))
        notes.push_back(*unscaled);
    noteWhatIsSetAlong(device, written, known, notes);
    if (const auto jump = jumpAfter(device, written, known))
        notes.push_back(*jump);
    if (set == PositionIsSet::no && needsPreset(device, written, known))
        notes.push_back({ValueNote::Id::presetNeeded, {}});
    return notes;
}

QString noteText(const ValueNote &note)
{
    return sentence(pattern(note), argumentTexts(note.arguments));
}

QString forceLabel(const ValueNote &note)
{
    return note.id == ValueNote::Id::scalingUnknown
               ? QCoreApplication::translate("ValueNotes", "Perhaps not in force")
               : QCoreApplication::translate("ValueNotes", "Not in force");
}

QString noteKey(ValueNote::Id id)
{
    return QString::fromLatin1(textFor(noteKeys, id, ""));
}

} // namespace codewheel
