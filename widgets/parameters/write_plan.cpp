// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/write_plan.h"

#include "catalog/device_description.h"
#include "drivers/values_to_write.h"
#include "line/line_encoder_session.h"
#include "line/typed_request.h"
#include "words/k3_word.h"

namespace codewheel {

namespace {

bool canBeWritten(const DeviceDescription &device, Parameter parameter)
{
    const ParameterDescription *description = device.find(parameter);
    return description != nullptr && description->canBeWritten();
}

ParameterValues writable(const DeviceDescription &device, const std::vector<Known> &known)
{
    ParameterValues values;
    for (const Known &one : known)
        if (canBeWritten(device, one.parameter))
            values.push_back({one.parameter, one.value});
    return values;
}

// The scaling factor is not asked for, it goes along with the steps: it stands in the request alone.
std::int64_t valueGiven(const Step &step, const WriteParameters &job)
{
    if (const auto wanted = valueOf(job.values, *step.parameter))
        return *wanted;
    const auto request = readRequest(QString::fromLatin1(step.line));
    return request ? request->data : 0;
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
    const auto steps = plannedForJobs(encoder, {plan.job}, k3::normalRunning);
    if (!steps && steps.error().id != RefusalId::nothingToDo)
        plan.refusal = steps.error();
    for (const Step &step : steps.value_or(std::vector<Step>()))
        if (writesValue(step))
            plan.rows.push_back({.value = {*step.parameter, valueGiven(step, plan.job)},
                                 .old = encoder.known(*step.parameter),
                                 .word = step.out,
                                 .request = step.line});
    plan.notes = valueNotes(device, plan.job.values, valuesOf(known),
                            plan.job.initialisePreset ? PositionIsSet::yes : PositionIsSet::no);
    return plan;
}

} // namespace codewheel
