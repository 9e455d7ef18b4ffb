// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "drivers/esc_settings.h"
#include "encoder/event.h"

#include <vector>

namespace codewheel {

// The words that `job` will put into OUT, or the requests it will send, step by step, as far as they can be
// told beforehand: what is read on the way may leave out values the encoder already has, and may make steps
// into steps - 1. For review before anything is sent; refused like the job itself where the input is bad. A
// WriteCams that writes only what differs reads each program first; what follows is told by `cams`, where the
// program is known. `out` is what stands in OUT; `escSettings` are those of a serial encoder.
Result<std::vector<Step>> plannedSteps(const DeviceDescription &device, const std::vector<Known> &known,
                                       const Job &job, const std::vector<KnownCams> &cams = {},
                                       Word out = k3::normalRunning, const EscSettings &escSettings = {});

} // namespace codewheel
