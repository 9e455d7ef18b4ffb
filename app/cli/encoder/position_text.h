// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/event.h"
#include "vocabulary/rod_scale.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace codewheel {

// A position in steps, and in millimetres if the scale of a rod is known; if there is none, what the encoder
// shows instead, and what is missing.
QString positionText(std::optional<std::int64_t> position, const Reading &shown,
                     const std::optional<RodScale> &scale = {});

// The state a job has left the encoder in, and what that means for its position.
QString whereItWasLeft(const Reading &left);
QString whereItWasLeft(const Outcome &outcome, const Reading &left);

} // namespace codewheel
