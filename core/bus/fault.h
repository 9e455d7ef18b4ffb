// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"
#include "vocabulary/role.h"

#include <vector>

namespace codewheel {

// What can be done about a fault from here; only its kind of bus knows how.
enum class FaultAction : std::uint8_t {
    start,        // the bus again
    switchOff,    // what is behind the fault, so that the rest can run
    confirm,      // it is over, or shall be checked again
    acknowledge,  // the watchdog of a gateway
    run,          // the encoder is in parameterization
    positionMode, // a job was cut off, and has left the encoder in another mode
    bringBack,    // what a job that was cut has left, and read what is not known since
};

// Something wrong on a bus, as reported to people: what, where, and what to do. Buses of all kinds have them
// (BusOutline::faults()).
struct Fault
{
    enum class Extent : std::uint8_t {
        standstill, // nothing goes over the bus
        bus,        // reported by the bus, which keeps running
        device,     // reported by a device, or it is silent
    };

    Extent extent = Extent::device;
    NodeId node{};                      // where to look; none: the bus as a whole
    StateWord shown{};                  // as in the bus structure
    QString text{};                     // in the user's language
    QString code{};                     // as listed in manuals; empty: not listed
    NodeId cutOff{};                    // the first device that is no longer reached
    std::vector<FaultAction> actions{}; // that make sense here

    // The same fault as before, whatever numbers its text counts.
    bool isSameAs(const Fault &other) const
    {
        return extent == other.extent && node == other.node && shown == other.shown && code == other.code;
    }
    friend bool operator==(const Fault &, const Fault &) = default;
};

// 0 is the worst.
int rankOf(const Fault &fault);

} // namespace codewheel
