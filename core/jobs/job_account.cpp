// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/job_account.h"

#include <algorithm>

namespace codewheel {

JobAccount::JobAccount(JobId id, const Job &job, const KnownValues &known)
    : before(known.values())
    , writesBefore(known.eepromWrites())
{
    outcome.job = id;
    if (const auto *write = std::get_if<WriteParameters>(&job))
        for (const ParameterValue &value : write->previous)
            replaceValue(before, value);
}

void JobAccount::read(const ParameterValue &value)
{
    replaceValue(outcome.read, value);
    replaceValue(before, value);
}

void JobAccount::notWritten(Parameter parameter)
{
    std::erase_if(outcome.written, [&](const ParameterValue &one) { return one.parameter == parameter; });
}

bool JobAccount::knowsBefore(const ParameterValues &taken) const
{
    return std::ranges::all_of(taken, [this](const ParameterValue &value) {
        return findValue(before, value.parameter).has_value();
    });
}

ParameterValues JobAccount::valuesBefore(const ParameterValues &taken) const
{
    ParameterValues values;
    for (const ParameterValue &value : taken)
        if (const Value was = *findValue(before, value.parameter); was != value.value)
            values.push_back({value.parameter, was});
    return values;
}

} // namespace codewheel
