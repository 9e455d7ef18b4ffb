// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "jobs/values_to_write.h"
#include "kinds/interbus/words/k3_word.h"
#include "vocabulary/event.h"

namespace codewheel {

// What views ask about a kind of device besides its capabilities.

// A magnet on a rod, not a shaft that turns.
inline bool isRod(const DeviceDescription &device)
{
    return device.profile == Profile::la66;
}

// Whether what the encoder takes is valid only after run (K3), or at once.
inline bool activatesByRun(const DeviceDescription &device)
{
    return device.profile == Profile::k3;
}

// Whether earlier values can be written again only behind a run, which first makes valid what was taken:
// where a parameter number must not come twice in a parameterization (Baumer manual 5).
inline bool restoresBehindRun(const DeviceDescription &device)
{
    return activatesByRun(device) && device.dialect != k3::Dialect::fraba;
}

// How to bring an encoder left in another state back to operation.
enum class WayBack : std::uint8_t { none, run, endService };
inline WayBack wayBack(const DeviceDescription &device, EncoderState leftIn)
{
    if (leftIn == EncoderState::service)
        return WayBack::endService;
    const bool isStuck = leftIn == EncoderState::parameterization || leftIn == EncoderState::error;
    return isStuck && activatesByRun(device) ? WayBack::run : WayBack::none;
}

} // namespace codewheel
