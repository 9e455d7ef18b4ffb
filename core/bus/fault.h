// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"
#include "encoder/role.h"

#include <vector>

namespace codewheel {

// What can be done about a fault from here; how, only its kind of bus knows.
enum class FaultAction : std::uint8_t {
    start,     // the bus, again
    switchOff, // what lies behind it, so that the rest can run
    confirm,   // it is over, or shall be looked at anew
};

// Something that is wrong on a bus, as people are told it: what, where, and what to do. Buses of all kinds
// have them (BusOutline::faults()).
struct Fault
{
    enum class Extent : std::uint8_t {
        standstill, // nothing goes over the bus
        bus,        // the bus tells it, and runs on
        device,     // a device tells it, or is silent
    };

    Extent extent = Extent::device;
    NodeId node{};                      // where to look; none: the bus as a whole
    StateWord shown{};                  // as in the bus structure
    QString text{};                     // in the user's language
    QString code{};                     // by which manuals list it; empty: none does
    NodeId cutOff{};                    // the first device that is not reached any more
    std::vector<FaultAction> actions{}; // that make sense

    // The same fault as before, whatever its text counts.
    bool isSameAs(const Fault &other) const
    {
        return extent == other.extent && node == other.node && shown == other.shown && code == other.code;
    }
    friend bool operator==(const Fault &, const Fault &) = default;
};

// 0 is worst.
int rankOf(const Fault &fault);

} // namespace codewheel
