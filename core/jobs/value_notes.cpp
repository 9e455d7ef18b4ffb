// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/value_notes.h"

#include "catalog/total_range.h"
#include "jobs/protocol.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

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

constexpr std::array scalingParameters{Parameter::steps, Parameter::revolutions, Parameter::measuringRange,
                                       Parameter::scalingFactor};

bool rescales(const ParameterValues &written)
{
    return std::ranges::any_of(scalingParameters,
                               [&](Parameter parameter) { return valueOf(written, parameter).has_value(); });
}

// Where the position jumps does not depend on the direction, so that need not be known.
ParameterValues withAnyDirection(const DeviceDescription &device, ParameterValues known)
{
    for (const Parameter parameter : {Parameter::direction, Parameter::coding})
        if (const ParameterDescription *found = device.find(parameter); found && !valueOf(known, parameter))
            known.push_back({parameter, found->minimum});
    return known;
}

// For an encoder on a serial line with scaling off, the position has all its steps whatever is written.
std::optional<ValueNote> jumpAfter(const DeviceDescription &device, const ParameterValues &written,
                                   const ParameterValues &known)
{
    ParameterValues then = known;
    for (const ParameterValue &value : written)
        replaceValue(then, value);
    if (!rescales(written) || valueOf(then, Parameter::scaling) == 0)
        return std::nullopt;
    if (const auto scale = scaleAfter(device, written, withAnyDirection(device, known)))
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
           std::ranges::any_of(scalingParameters, [&](Parameter parameter) {
               const auto value = valueOf(written, parameter);
               return value && value != valueOf(known, parameter);
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

QString noteKey(ValueNote::Id id)
{
    switch (id) {
    case ValueNote::Id::revolutionsSetAlong:
        return QStringLiteral("revolutionsSetAlong");
    case ValueNote::Id::rangeJumps:
        return QStringLiteral("rangeJumps");
    case ValueNote::Id::revolutionsJump:
        return QStringLiteral("revolutionsJump");
    case ValueNote::Id::fractionJumps:
        return QStringLiteral("fractionJumps");
    case ValueNote::Id::presetNeeded:
        return QStringLiteral("presetNeeded");
    }
    return {};
}

} // namespace codewheel
