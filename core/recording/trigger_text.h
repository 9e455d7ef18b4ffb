// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recording_trigger.h"

#include <functional>
#include <tl/expected.hpp>

namespace codewheel {

// A trigger as it is typed at the command line and kept in settings, the same in every language:
//
//     1.0/in.25, 1.0/in.25=0    a bit of a word, or a cam, becomes 1, or 0
//     1.0/position>1000         it comes from below 1000, and reaches it; <: it falls below it. In steps; a
//                               speed in steps per second, with up to three decimals
//     fault, 1.0/fault,         a message of this severity or worse: from anywhere, of an encoder, or of a
//     bus:3/fault               bus and all that is on it
QString triggerKey(const RecordingTrigger &trigger);

// What is wrong with a text that is no trigger.
enum class TriggerFault : std::uint8_t {
    form,    // it is none of the above
    place,   // there is no such place, or an encoder is needed and it is a bus
    channel, // it has no such value
    bit,     // the word has no such bit
    number,  // of a threshold
};

std::optional<Place> triggerPlace(const QString &text); // "1.0", "4/esc:05", "bus:3"
// `placeOf` finds the place that somebody typed.
tl::expected<RecordingTrigger, TriggerFault>
parseTrigger(const QString &text,
             const std::function<std::optional<Place>(const QString &text)> &placeOf = triggerPlace);

} // namespace codewheel
