// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/event.h"

#include <QStringList>

namespace codewheel {

// In a sentence, with the date and time of when it became known.
QString howKnown(const std::optional<Known> &known, const EncoderSession &encoder);
// Why even a word written by hand, which the encoder has confirmed, does not tell its steps; empty: it does.
QString whyNotToldByWord(Parameter parameter, const EncoderSession &encoder);

// "8 192 steps", "3 (CW)". options: valueText().
QString valueWithUnit(const DeviceDescription &device, const ParameterValue &value,
                      const KindData &options = {});
// "Steps = 255, Direction = 3 (CW)"
QString valueList(const DeviceDescription &device, const ParameterValues &values);
// "8 192 steps (read)"; "unknown".
QString knownText(const DeviceDescription &device, const std::optional<Known> &known);

// That the previous values are in the encoder again, and how that is known; empty if they are not.
QString restoredText(const std::optional<Evidence> &restored);

// Before a position is set: that the encoder moves; and before that, what it shows now.
QStringList movementTexts(const EncoderSession &encoder);
QStringList positionNowTexts(const EncoderSession &encoder);

bool isCancelled(const Outcome &outcome);
// What a cancelled job wrote, which is valid now, and where the position went. Empty if nothing was written,
// or all was restored.
QStringList validNowTexts(const EncoderSession &encoder, const Outcome &outcome);

// The state an encoder was left in, as a sentence.
QString leftInText(EncoderState state);
// Both: the restored values, and the state it was left in.
QString endText(const Outcome &outcome);

} // namespace codewheel
