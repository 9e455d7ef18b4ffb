// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/job.h"
#include "encoder/known.h"

#include <variant>
#include <vector>

namespace codewheel {

// What the window asks of the bus thread.
namespace command {
struct SetOut
{
    std::size_t device;
    Word word;
};
struct StartJob
{
    std::size_t device;
    JobId id;
    Job job;
    Pace pace;
};
struct Proceed
{
    std::size_t device;
};
struct Cancel
{
    std::size_t device;
    OnCancel how;
};
struct SetKnown
{
    std::size_t device;
    std::vector<Known> known;
};
struct StartBus
{};
struct StopBus
{};
struct SetOperate
{
    bool on;
};
struct AlarmStop
{};
} // namespace command
using Command =
    std::variant<command::SetOut, command::StartJob, command::Proceed, command::Cancel, command::SetKnown,
                 command::StartBus, command::StopBus, command::SetOperate, command::AlarmStop>;

} // namespace codewheel
