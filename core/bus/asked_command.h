// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/job_command.h"

namespace codewheel::command {

// What a window asks of the thread of any bus whose encoders are asked, besides what a session asks its
// driver. A device is given by its index in the order in which they were added.
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

} // namespace codewheel::command
