// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"

#include <chrono>

namespace codewheel {

// How long a bus cycle takes on the wire of a real ring, to be shown as "about", naming the form. The manuals
// of two generations of masters give different formulas.
enum class CycleTimeForm { g3, g4 };

inline constexpr double longestRemoteBus = 12.8; // km

// What the time depends on.
struct RingLoad
{
    int dataBytes = 0;        // in the ring, the larger of IN and OUT of each device
    int remoteBusDevices = 0; // n.0
    double cableKilometres = 0;
};
RingLoad ringLoad(const RingStructure &structure, double cableKilometres = 0);

using MicrosecondsOnTheWire = std::chrono::duration<double, std::micro>;
inline constexpr MicrosecondsOnTheWire bitAt500kBd{2.0};
inline constexpr MicrosecondsOnTheWire bitAt2MBd{0.5};

MicrosecondsOnTheWire cycleTime(const RingLoad &load, MicrosecondsOnTheWire bit, CycleTimeForm form);

} // namespace codewheel
