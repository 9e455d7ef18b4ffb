// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/protocol.h"
#include "vocabulary/hex.h"

namespace codewheel {

// What a step of a job does, whatever the bus: "Steps = 255", "Read steps", "Run: the values become valid",
// "Read the position of 05". Used by the wizard, the panels' job strip and the reports.
inline QString stepText(const DeviceDescription &device, const Step &step)
{
    return protocolOf(device).stepText(device, step);
}

// What is sent: "020000FF", "03GP00005200".
inline QString sentText(const Step &step)
{
    return step.line.isEmpty() ? hexWord(step.out) : QString::fromLatin1(step.line);
}

} // namespace codewheel
