// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"

namespace codewheel {

// The description with the range these options give a value that depends on them, such as a scaling factor;
// all others unchanged.
ParameterDescription withOptions(ParameterDescription parameter, const KindData &options);

// The name of a value in the user's language: "CW", "unsigned, CW". Empty where the value has none.
QString choiceName(const ParameterDescription &parameter, const Value &value);

// A value for the user, without its unit: "8 192", "3 (CW)", "21.5" for 215 tenths of a degree; what is not a
// plain number in its form (ValueForm): "0012D503".
QString valueText(const ParameterDescription &parameter, const Value &value, const KindData &options = {});

// "a text of at most 16 characters"
QString textLimit(const ParameterDescription &parameter);

// The unit that goes with valueText(): "steps", "°C"; empty if there is none. `of` this number: "1
// revolution".
QString unitText(Unit unit, const std::optional<Value> &of = {});
// That of this value; empty also where it is told in words.
QString unitText(const ParameterDescription &parameter, const Value &value);

} // namespace codewheel
