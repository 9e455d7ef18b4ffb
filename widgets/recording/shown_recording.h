// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/bus_recorder.h"

namespace codewheel {

// What is seen of a recording that runs, or waits for its trigger.
struct ShownRecording
{
    RecordingPlan plan;
    bool waits = false;             // for its trigger
    std::optional<TimeSpan> span{}; // nothing: nothing has come as yet
    RecordingStatus status{};
};

} // namespace codewheel
