// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/step.h"

namespace codewheel {

// What one step of a handshake is about; Step::kind of encoders with words.
enum class StepKind : std::uint8_t {
    toNormal,
    parameter,
    run,
    initialisePreset,
    readOut,
    endReadOut,
    word,
    manufacturerPreset, // one bus cycle long
    switchMode,
    camParameter, // start, stop, cam configuration, shift_iw: acknowledged in cam parameterization
    camReadOut,
    service,    // LA-66: service number and data, the service bit still 0
    serviceBit, // LA-66: the same with D31 = 1, until the encoder acknowledges
};

// What such a step does to the encoder.
Effect effectOf(StepKind kind, Word out);

// Its line in the wizard.
QString wordStepText(const DeviceDescription &device, const Step &step);

} // namespace codewheel
