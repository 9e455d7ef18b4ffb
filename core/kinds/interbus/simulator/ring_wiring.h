// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"

#include <cstdint>

namespace codewheel {

// What is wrong with one place of the ring itself.
struct PlaceTrouble
{
    bool wireBroken = false; // the cable before the device
    bool supplied = true;    // the whole device; without supply the ring is interrupted there
    bool wrongDevice = false;
    bool peripheralFault = false; // the cause of one
    int crcErrors = 0;            // faulty data cycles per 1000 in the segment that begins here
};

// The current state of the cables and devices of a simulated ring, by place. SimulatedRing changes it,
// SimulatedMaster looks at it.
class RingWiring
{
public:
    void add(RingDevice participant);

    std::size_t size() const { return m_planned.size(); }
    const RingStructure &planned() const { return m_planned; }
    const PlaceTrouble &trouble(std::size_t place) const { return m_troubles[place]; }
    void setTrouble(std::size_t place, const PlaceTrouble &trouble);
    // Counts up with each change.
    std::uint64_t changes() const { return m_changes; }
    bool hasCrcErrors() const { return m_hasCrcErrors; }

    // Whether a device other than the planned one can be put there: not in place of a bus terminal.
    bool canBeWrong(std::size_t place) const;
    // What the ID register at a place says; without a make.
    RingDevice present(std::size_t place) const;
    // The devices an ID cycle finds, in ring order: without supply, or behind a broken wire, a device is not
    // found.
    std::vector<std::size_t> reachable() const;

private:
    RingStructure m_planned;
    std::vector<PlaceTrouble> m_troubles;
    std::uint64_t m_changes = 0;
    bool m_hasCrcErrors = false;
};

// The place after the last one that is cut off together with `place`: on a local bus the rest of it, on the
// remote bus everything that follows on its line and below it.
std::size_t endOfCutOff(const RingStructure &ring, std::size_t place);

} // namespace codewheel
