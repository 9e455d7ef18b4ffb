// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/protocol.h"

namespace codewheel {

// What to say about an encoder that shows an error by itself: no job asked it for anything.
inline Refusal shownError(const DeviceDescription &device, const Reading &reading)
{
    return reading.errorNumber.value_or(0) == 0
               ? Refusal{RefusalKind::device, RefusalId::noValidPosition, {reading.in}}
               : protocolOf(device).shownError(device, reading);
}

} // namespace codewheel
