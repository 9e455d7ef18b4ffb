// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/protocol_rules.h"
#include "jobs/values_to_write.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/event.h"

namespace codewheel {

// What views ask about a kind of device besides its capabilities.

// Whether what the encoder shows now came after the end of a job: what that has left, or what became of it
// since.
inline bool isSeenSince(const EncoderSession &encoder, Instant end)
{
    constexpr Instant untilSeen = std::chrono::milliseconds(200);
    return encoder.freshness().isLive() && encoder.latest().at > end + untilSeen;
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
