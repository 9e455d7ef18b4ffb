// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_work.h"
#include "kinds/canopen/bus/canopen_command.h"
#include "kinds/canopen/bus/canopen_event.h"
#include "kinds/canopen/bus/canopen_snapshot.h"

#include <memory>

namespace codewheel {

// Owns the link to a CAN bus with CANopen, and all transfers: one for each node, side by side.
//
// In Watch the bus is listened to, and nothing is sent. In Operate the drivers of the nodes are asked what
// they want to send. Where another master is heard nothing is sent either until the user agrees. When the
// adapter is gone, or has left the bus, that is reported once, the jobs end, and it is opened again each
// second, in Watch.
class CanopenRunner final : public BusRunner<CanopenCommand, CanopenEvent, CanopenSnapshot>
{
public:
    // Opened for `use`. `rate` is what the adapter is set to, in Bd, unless it tells.
    CanopenRunner(CanLink &link, int rate, CanUse use);
    ~CanopenRunner() override;

    Result<void> open(const std::stop_token &stop) override;
    void turn(Instant until) override;
    void slept(std::chrono::milliseconds duration) override;
    void close() override;
    Instant now() const override;
    void interrupt() override;
    void post(CanopenCommand command) override; // does not wait for what the bus is doing

private:
    struct Private;
    std::unique_ptr<Private> d;
};

// The link as messages and refusals store it.
QString linkArgument(const CanLink &link);

} // namespace codewheel
