// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/trouble.h"

#include <functional>
#include <vector>

namespace codewheel {

// A CAN interface of this computer, as the form of its link shows it.
struct CanInterfaceRow
{
    QString name;  // "can0"
    QString state; // what the system tells of it: "on, 250 kBit/s, listens only"
    // What is in its way or worth knowing, and the command against it, if the bus has this rate (Bd); empty:
    // nothing.
    std::function<Trouble(int rate)> trouble{};
};

// All there are, or why there are none.
struct CanInterfaceRows
{
    std::vector<CanInterfaceRow> rows;
    Trouble none{}; // shown with an empty list
};

} // namespace codewheel
