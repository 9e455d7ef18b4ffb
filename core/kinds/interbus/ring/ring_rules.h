// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"

#include <cstddef>
#include <vector>

namespace codewheel {

// The limits of a ring (Phoenix Contact, data sheets of G4 masters).
namespace ring_limit {
inline constexpr int devices = 512;
inline constexpr int remoteDevices = 254;
inline constexpr int levels = 16;
inline constexpr int points = 4096; // each way; 256 words
inline constexpr int localDevices = 63;
inline constexpr int pcpDevices = 62;
} // namespace ring_limit

// How much of each limit a structure uses.
struct RingCounts
{
    int devices = 0;
    int remoteDevices = 0;
    int levels = 0;
    int inPoints = 0; // whole words, as in the process image
    int outPoints = 0;
    int longestLocalBus = 0;
    int pcpDevices = 0;
};
RingCounts countRing(const RingStructure &structure);

enum class RingRule : std::uint8_t {
    devices,
    remoteDevices,
    levels,
    inPoints,
    outPoints,
    localDevices,
    pcpDevices,
    localBusNeedsTerminal,
    branchNeedsTerminal,
    terminalOnLocalBus,
};

// A rule that a structure breaks.
struct RingFinding
{
    RingRule rule = RingRule::devices;
    std::size_t device = 0; // the first that breaks it
    int count = 0;          // of whatever is limited, or of the devices that break the rule
    int limit = 0;

    friend bool operator==(const RingFinding &, const RingFinding &) = default;
};
std::vector<RingFinding> checkRing(const RingStructure &structure);

// A sentence in the user's language.
QString ringFindingText(const RingFinding &finding, const RingStructure &structure);

} // namespace codewheel
