// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/event.h"

#include <variant>
#include <vector>

namespace codewheel {

// What a session asks of the driver of its device, whatever the bus; the runner of the bus carries it there.
// The device is given by its index in that runner.
namespace command {
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
} // namespace command
using JobCommand = std::variant<command::StartJob, command::Proceed, command::Cancel, command::SetKnown>;

// The outcome of a job that was not accepted.
inline Outcome notTaken(JobId job, const Refusal &why, EncoderState leftIn)
{
    Outcome outcome;
    outcome.job = job;
    outcome.result = tl::unexpected(why);
    outcome.leftIn = leftIn;
    outcome.foundInParameterization = leftIn == EncoderState::parameterization;
    return outcome;
}

} // namespace codewheel
