// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/participant.h"

#include <span>
#include <vector>

namespace codewheel {

inline constexpr unsigned busTerminalIdCode = 0x0C;

// One device of a ring. The master finds it (ID register); the vendor is not in the ID code: without a plan,
// deviceKey is empty and the make is not known.
struct RingDevice
{
    NodeId number;           // "6.1"
    unsigned deviceCode = 0; // length code << 8 | ID code: 0237h
    int inWords = 0;         // 16 bit each
    int outWords = 0;
    QString deviceKey; // catalog key
    int level = 0;     // of the remote bus, 0..15: 0 is the main line, each branch one more

    unsigned idCode() const { return deviceCode & 0xFF; } // 37h

    operator Participant() const; // as everybody knows it
    friend bool operator==(const RingDevice &, const RingDevice &) = default;
};
RingDevice ringDevice(const Participant &participant);

using RingStructure = std::vector<RingDevice>;

RingStructure ringStructure(std::span<const Participant> participants);
std::vector<Participant> participantsOf(const RingStructure &ring);

// Whether both are the same ring as far as a master can tell: all but the makes.
bool isSameRing(const RingStructure &ring, const RingStructure &other);

} // namespace codewheel
