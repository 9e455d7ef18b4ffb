// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/reading.h"

#include <vector>

namespace codewheel {

// Master states (IBS SYS FW G4): READY, ACTIVE (ID cycles), RUN (data cycles), BUS FAIL.
enum class MasterState : std::uint8_t { ready, active, run, busFail };

// The ring as it stood after one cycle, with the bits that changed in any cycle since the last snapshot was
// taken.
struct Snapshot
{
    struct Device
    {
        Word out = 0;
        Word in = 0;
        Word outEdges = 0;
        Word inEdges = 0;
        Reading reading;
        bool heldByJob = false;
    };

    std::uint64_t cycle = 0;
    Instant at{};
    MasterState state = MasterState::ready;
    bool operate = false;              // writing is allowed
    std::uint64_t lateCycles = 0;      // counted by the paced thread since it started
    std::chrono::nanoseconds period{}; // of the paced thread; 0 when cycles are driven by hand
    std::uint64_t droppedRows = 0;     // trace rows lost because nobody took them
    std::vector<Device> devices;       // in ring order
};

} // namespace codewheel
