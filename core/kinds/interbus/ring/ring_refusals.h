// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel {

// What only a ring or its master refuses. The comment beside each lists its arguments.
enum class RingRefusalId : std::uint8_t {
    deviceCodeDiffers,         // place, its device code, device name, device code of that device
    faultPlanBroken,           // file, line, key, reason
    masterServiceNotSupported, // text of the service
    masterStateWrong,          // text of the service, text of the state
    noConfiguration,           //
    busFault,                  // error code (Word), diagnostic parameter (Word): see bus_fault.h
    notInRing,                 // place
};
extern const RefusalFamily ringRefusals;
constexpr const RefusalFamily &familyOf(RingRefusalId)
{
    return ringRefusals;
}

} // namespace codewheel
