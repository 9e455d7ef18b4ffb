// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/job_command.h"

namespace codewheel {

// What a window asks of the thread of any bus whose encoders are asked, besides what a session asks its
// driver. A device is given by its index in the order in which they were added.
namespace command {
struct RemoveDevice // its index stays unused
{
    std::size_t device;
};
struct SetRunning // the drivers are asked what they want to send; required for jobs
{
    bool on;
};
struct SetOperate
{
    bool on;
};
struct AlarmStop
{};
struct CancelScan
{};
} // namespace command

// And what its kind of bus adds.
template <typename... OfKind>
using AskedCommand = std::variant<command::StartJob, command::Proceed, command::Cancel, command::SetKnown,
                                  command::RemoveDevice, command::SetRunning, command::SetOperate,
                                  command::AlarmStop, command::CancelScan, OfKind...>;

} // namespace codewheel
