// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/known_values.h"

namespace codewheel {

// What a job has read and written by now, as its outcome will tell it, and what the encoder had before. Kept
// by JobRun.
struct JobAccount
{
    // `known`: what the encoder has as far as it is known, and the count of its EEPROM writes. The values the
    // job itself tells from before go over them.
    JobAccount(JobId id, const Job &job, const KnownValues &known);

    // The encoder told the value; what is written later changes it.
    void read(ParameterValue value);
    void written(ParameterValue value) { replaceValue(outcome.written, value); }
    void notWritten(Parameter parameter); // after all

    // Whether it is known what the encoder had in place of all of these values, and what that was.
    bool knowsBefore(const ParameterValues &taken) const;
    ParameterValues valuesBefore(const ParameterValues &taken) const; // knowsBefore()

    Outcome outcome;
    ParameterValues before;
    int writesBefore; // to EEPROM
};

} // namespace codewheel
