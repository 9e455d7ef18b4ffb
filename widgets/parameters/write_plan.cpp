// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/write_plan.h"

#include "catalog/device_description.h"
#include "drivers/k3_plan.h"

namespace codewheel {

namespace {

std::vector<Known> everythingKnown(const EncoderSession &encoder)
{
    std::vector<Known> all;
    for (const Parameter parameter : allParameters())
        if (const auto known = encoder.known(parameter))
            all.push_back(*known);
    return all;
}

// A value that was only told is not sure where the encoder can be asked.
bool isThere(const EncoderSession &encoder, const ParameterValue &value)
{
    const auto known = encoder.known(value.parameter);
    return known && known->value == value.value &&
           (known->evidence != Evidence::told || !encoder.can().reads);
}

bool isRead(const EncoderSession &encoder, Parameter parameter)
{
    const auto known = encoder.known(parameter);
    return known && known->evidence == Evidence::read;
}

} // namespace

WritePlan planWrite(const EncoderSession &encoder, const ParameterValues &wanted, bool writeAll)
{
    const DeviceDescription &device = encoder.device();
    K3Knowledge knowledge(device);
    const std::vector<Known> all = everythingKnown(encoder);
    knowledge.set(all);
    const K3Plan words(device, knowledge);

    WritePlan plan;
    for (const ParameterDescription &parameter : device.parameters) {
        const auto value = valueOf(wanted, parameter.parameter);
        if (!value || !parameter.number)
            continue;
        const ParameterValue one{parameter.parameter, *value};
        if (!writeAll && isThere(encoder, one)) {
            ++plan.alreadyThere;
            continue;
        }
        plan.job.values.push_back(one);
        plan.rows.push_back(
            {one, encoder.known(one.parameter), words.parameterWord(one.parameter, one.value)});
        if (!writeAll && encoder.can().reads && !isRead(encoder, one.parameter))
            plan.job.onlyWhatDiffers = true;
    }
    for (const Known &known : all)
        if (const auto *parameter = device.find(known.parameter); parameter && parameter->number)
            plan.job.previous.push_back({known.parameter, known.value});
    plan.stepsMayBeLess = valueOf(plan.job.values, Parameter::steps) && !knowledge.countsStepsMinusOne();
    return plan;
}

} // namespace codewheel
