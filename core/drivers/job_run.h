// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/event.h"

namespace codewheel {

// A job on its way, as every cyclic driver keeps it; a driver adds its steps and what it reads.
struct JobRun
{
    JobRun() = default;
    // `known`: the values the encoder has as far as they are known. Those the job tells from before go over
    // them.
    JobRun(JobId jobId, Job given, Pace how, ParameterValues known)
        : id(jobId)
        , job(std::move(given))
        , pace(how)
        , before(std::move(known))
    {
        if (const auto *write = std::get_if<WriteParameters>(&job))
            for (const ParameterValue &value : write->previous)
                replaceValue(before, value);
    }

    // Steps are planned once IN is known. What was cancelled before that is not planned any more.
    bool needsPlan() const { return !prepared && !cancelled; }

    JobId id = 0;
    Job job;
    Pace pace = Pace::byItself;
    bool prepared = false;          // its steps are planned
    std::size_t index = 0;          // of the current step
    bool begun = false;             // the current step is in OUT, or goes there now
    bool mayBegin = false;          // by hand: the user said "next step"
    bool asked = false;             // by hand: the user was told that it waits
    std::optional<Refusal> failure; // the remaining steps only bring OUT back
    std::optional<OnCancel> cancelled;
    bool cancelPlanned = false; // its steps have been appended
    bool restores = false;      // the last steps give the values from before back
    int writesBefore = 0;       // to EEPROM
    ParameterValues before;     // values from before this job
    ParameterValues written;
    ParameterValues alreadyThere;
    ParameterValues read;
    std::optional<std::int64_t> positionBefore;
    std::optional<std::int64_t> positionAfter;
};

} // namespace codewheel
