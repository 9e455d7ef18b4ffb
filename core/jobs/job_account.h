// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/known_values.h"

namespace codewheel {

// What a job has read and written so far, as its outcome will report it, and what the encoder had before.
// Kept by JobRun.
struct JobAccount
{
    // `known`: what the encoder is known to have, and the count of its EEPROM writes. Previous values given
    // by the job itself take precedence.
    JobAccount(JobId id, const Job &job, const KnownValues &known);

    // The value was read from the encoder; what is written later changes it.
    void read(const ParameterValue &value);
    void written(const ParameterValue &value) { replaceValue(outcome.written, value); }
    void notWritten(Parameter parameter); // after all

    // Whether it is known what the encoder had in place of all these values, and what that was.
    bool knowsBefore(const ParameterValues &taken) const;
    ParameterValues valuesBefore(const ParameterValues &taken) const; // requires knowsBefore()

    Outcome outcome;
    ParameterValues before;
    int writesBefore; // to EEPROM
};

} // namespace codewheel
