// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asking_runner.h"
#include "kinds/canopen/bus/canopen_command.h"
#include "kinds/canopen/bus/canopen_event.h"
#include "kinds/canopen/bus/canopen_snapshot.h"

namespace codewheel {

// Owns the link to a CAN bus with CANopen, and all transfers: one for each node, side by side.
//
// In Watch the bus is listened to, and nothing is sent. In Operate the drivers of the nodes are asked what
// they want to send. Where another master is heard nothing is sent either until the user agrees. An
// adapter that has left the bus is as good as gone.
class CanopenRunner final : public AskingRunner<CanopenCommand, CanopenEvent, CanopenSnapshot>
{
public:
    // Opened for `use`. `rate` is what the adapter is set to, in Bd, unless it tells.
    CanopenRunner(CanLink &link, int rate, CanUse use);
};

// The link as messages and refusals store it.
QString linkArgument(const CanLink &link);

} // namespace codewheel
