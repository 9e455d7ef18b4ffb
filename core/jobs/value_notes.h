// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "jobs/position_scale.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/known.h"
#include "vocabulary/refusal.h"

#include <vector>

namespace codewheel {

// Side effects of values to be written that whoever sets them would want to know beforehand. Shown wherever
// values are set: write plans, wizard, command line.
struct ValueNote
{
    enum class Id : std::uint8_t {
        revolutionsSetAlong, // revolutions from then on, now (empty: not known)
        rangeJumps,          // measuring range in turns, physical turns, steps (empty: not known)
        revolutionsJump,     // revolutions of a serial encoder, physical turns, steps
        fractionJumps,  // steps, revolutions, turns, physical turns, steps of the jump (0: less than one)
        presetNeeded,   //
        scalingOff,     // what scales the position is kept, but does not act
        scalingUnknown, // likewise, perhaps
        offsetLeftOut,  // the wanted zero offset, which setting the position replaces
        positionShifts, // position now, position then (both empty: not known)
        positionShiftsAbout, // likewise, with a step or so more or less
        presetUsedUp,        // the one that is there acts once more only if it is written again
        presetMayBeUsedUp,   // likewise, perhaps: that is read first
    };

    Id id = Id::revolutionsSetAlong;
    std::vector<RefusalArgument> arguments;

    friend bool operator==(const ValueNote &, const ValueNote &) = default;
};

// The values in what is known of an encoder.
ParameterValues valuesOf(const std::vector<Known> &known);

enum class PositionIsSet : std::uint8_t { no, yes };

// For writing `written` to an encoder that is known to have `known`; afterwards its position may be set.
std::vector<ValueNote> valueNotes(const DeviceDescription &device, const ParameterValues &written,
                                  const ParameterValues &known, PositionIsSet set = PositionIsSet::no);

// Whether `parameter` scales the position, so that it acts only while the encoder scales it.
bool isOfScaling(Parameter parameter);
// That values of `written` do not act, or may not: the encoder keeps them, but does not scale its position,
// as far as `known` tells. Empty if they do, or none of them would scale it.
std::optional<ValueNote> scalingNote(const DeviceDescription &device, const ParameterValues &written,
                                     const ParameterValues &known);
// As far as the encoder is known now.
std::optional<ValueNote> scalingNote(const EncoderSession &encoder, const ParameterValues &written);

// Where, and how far, the position jumps with this scale (docs/protocols/k3.md, arithmetic); empty if it goes
// on.
std::optional<ValueNote> jumpNote(const DeviceDescription &device, const PositionScale &scale);

QString noteText(const ValueNote &note); // a sentence or two
// Above a scalingNote(): "Not in force".
QString forceLabel(const ValueNote &note);
QString noteKey(ValueNote::Id id); // for JSON: "revolutionsSetAlong"

} // namespace codewheel
