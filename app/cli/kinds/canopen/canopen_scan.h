// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "kinds/canopen/bus/canopen_facts.h"

#include <array>

namespace codewheel {

class CanopenAccess;
struct NodeOnBus;

inline constexpr std::array scanCanOptions{
    Option{"--ask", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "CAN bus: also ask each of the nodes 1 to 127 what it is; sends on the bus")},
    Option{"--listen", "SECONDS", QT_TRANSLATE_NOOP("codewheel::CommandLine", "CAN bus: listen so long (3)")},
};

// As long as the whole of a log, unless --listen says how long.
Checked<Instant> timeToListen(const Call &call, const CanopenAccess &bus);

// Who is on the bus: listens, and with --ask asks. Ctrl+C ends it, keeping what was found so far.
struct ScannedCan
{
    Answer answer;
    std::vector<NodeOnBus> nodes;
};
Checked<ScannedCan> scanCan(const Call &call, CanopenAccess &bus);

} // namespace codewheel
