// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recording_trigger.h"

#include <QString>

namespace codewheel {

// "34.1 MB"
QString sizeText(std::int64_t bytes);
// "0:12:34", as a clock that counts.
QString countedText(Instant duration);
// What is waited for: "1.0: IN bit 25 becomes 1".
QString triggerText(const RecordingTrigger &trigger);

// How long the room will do, before anything is recorded.
struct RecordingRoom
{
    std::int64_t free = 0;      // bytes of the disk
    std::int64_t leastFree = 0; // that are to stay
    Instant keptFor{};          // 0: without this limit
    std::int64_t largestSize = 0;
    std::optional<double> bytesPerSecond{};

    bool isEnough() const { return free > leastFree; }
};
QString roomText(const RecordingRoom &room);

} // namespace codewheel
