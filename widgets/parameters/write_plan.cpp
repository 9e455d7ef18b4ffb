// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/write_plan.h"

#include "catalog/device_description.h"
#include "drivers/planned_words.h"
#include "drivers/values_to_write.h"

namespace codewheel {

namespace {

bool isWritable(const DeviceDescription &device, Parameter parameter)
{
    const ParameterDescription *description = device.find(parameter);
    return description != nullptr && description->canBeWritten();
}

ParameterValues writable(const DeviceDescription &device, const std::vector<Known> &known)
{
    ParameterValues values;
    for (const Known &one : known)
        if (isWritable(device, one.parameter))
            values.push_back({one.parameter, one.value});
    return values;
}

} // namespace

WritePlan planWrite(const EncoderSession &encoder, const ParameterValues &wanted, bool writeAll)
{
    const DeviceDescription &device = encoder.device();
    const std::vector<Known> known = allKnown(encoder);
    WritePlan plan{
        .job = jobForWish(encoder, {.wanted = wanted, .initialisePreset = false, .writeAll = writeAll})};
    plan.job.previous = writable(device, known);
    plan.alreadyThere = static_cast<int>(wanted.size() - plan.job.values.size());
    plan.stepsMayBeLess = device.quirks.mayCountStepsMinusOne &&
                          !encoder.known(Parameter::multiTurnAndStepsMinusOne) &&
                          valueOf(plan.job.values, Parameter::steps);
    if (const auto steps = plannedSteps(device, known, plan.job))
        for (const Step &step : *steps)
            if (writesValue(step))
                plan.rows.push_back({{*step.parameter, *valueOf(plan.job.values, *step.parameter)},
                                     encoder.known(*step.parameter),
                                     step.out});
    return plan;
}

} // namespace codewheel
