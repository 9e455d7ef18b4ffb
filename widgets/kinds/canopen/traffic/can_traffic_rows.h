// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/traffic.h"
#include "kinds/canopen/protocol/sdo_dialogues.h"

#include <map>

namespace codewheel {

// Adds to the rows of a bus one for each transfer of an object, when it has ended: its value as a whole, and
// the time it took. The rows of its frames say that they belong to one.
class CanTrafficRows
{
public:
    // The row itself, behind those that have ended with it.
    std::vector<TrafficRow> next(const TrafficRow &row);
    // Those for whose answer nobody waits any longer.
    std::vector<TrafficRow> overdue(Instant now);

private:
    TrafficRow whole(const canopen::SdoDialogue &ended);

    canopen::SdoDialogues m_dialogues;
    std::map<int, TrafficRow> m_begun; // by node
};

} // namespace codewheel
