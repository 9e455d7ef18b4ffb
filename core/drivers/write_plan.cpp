// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/write_plan.h"

#include "catalog/device_description.h"
#include "encoder/hex.h"

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

// What goes along is not asked for: its value stands in the request alone.
WritePlan::Row rowFor(const Step &step, const WritePlan &plan, const EncoderSession &encoder)
{
    const Parameter parameter = *step.parameter;
    WritePlan::Row row{.value = {parameter, 0}, .known = encoder.known(parameter), .step = step};
    if (const auto wanted = valueOf(plan.job.values, parameter)) {
        row.value.value = *wanted;
    } else {
        row.value.value = step.data.value_or(0);
        row.goesAlong = true;
    }
    return row;
}

} // namespace

QString sentText(const Step &step)
{
    return step.kind == StepKind::request ? QString::fromLatin1(step.line) : hexWord(step.out);
}

WritePlan planWrite(const EncoderSession &encoder, const WriteWish &wish)
{
    const DeviceDescription &device = encoder.device();
    const std::vector<Known> known = allKnown(encoder);
    WritePlan plan{.job = jobForWish(encoder, wish)};
    plan.job.previous = writable(device, known);
    plan.stepsMayBeLess = device.quirks.mayCountStepsMinusOne &&
                          !encoder.known(Parameter::multiTurnAndStepsMinusOne) &&
                          valueOf(plan.job.values, Parameter::steps);
    const auto steps = encoder.planned({plan.job});
    if (!steps && steps.error().id != RefusalId::nothingToDo)
        plan.refusal = steps.error();
    for (const Step &step : steps.value_or(std::vector<Step>()))
        if (writesValue(step))
            plan.rows.push_back(rowFor(step, plan, encoder));
    for (const ParameterValue &wanted : wish.wanted)
        if (!valueOf(plan.job.values, wanted.parameter))
            plan.leftOut.push_back(wanted);
    plan.notes = valueNotes(device, plan.job.values, valuesOf(known),
                            plan.job.initialisePreset ? PositionIsSet::yes : PositionIsSet::no);
    return plan;
}

} // namespace codewheel
