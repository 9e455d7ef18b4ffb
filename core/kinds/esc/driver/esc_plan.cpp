// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_plan.h"

#include "kinds/esc/driver/esc_values.h"

#include <algorithm>
#include <array>
#include <utility>

namespace codewheel {
namespace {

// In the order of their commands in the manual; the factor, which makes the others take effect, last.
constexpr std::array scalingValues{Parameter::steps, Parameter::revolutions, Parameter::measuringRange,
                                   Parameter::scalingFactor};

bool movesTheEncoder(Parameter parameter)
{
    return parameter == Parameter::lineAddress || parameter == Parameter::baudRate;
}

} // namespace

bool isEscScaling(Parameter parameter)
{
    return std::ranges::find(scalingValues, parameter) != scalingValues.end();
}

bool isBoundToEscFactor(Parameter parameter)
{
    return parameter == Parameter::steps || parameter == Parameter::measuringRange;
}

bool goesAlongOnEsc(Parameter parameter, const ParameterValues &written)
{
    if (parameter == Parameter::scalingFactor)
        return std::ranges::any_of(
            written, [](const ParameterValue &value) { return isBoundToEscFactor(value.parameter); });
    return (parameter == Parameter::revolutions || parameter == Parameter::measuringRange) &&
           valueOf(written, Parameter::steps);
}

EscSteps EscPlan::stepsFor(const Job &job) const
{
    EscSteps steps;
    if (const auto *read = std::get_if<ReadParameters>(&job)) {
        appendReads(steps, read->parameters);
    } else if (const auto *write = std::get_if<WriteParameters>(&job)) {
        const ParameterValues values = completed(write->values);
        std::vector<Parameter> first;
        for (const ParameterValue &value : values)
            if (write->onlyWhatDiffers || value.parameter == Parameter::scalingFactor)
                first.push_back(value.parameter);
        appendReads(steps, first);
        const EscSteps more = writes(values);
        steps.insert(steps.end(), more.begin(), more.end());
    } else if (const auto *set = std::get_if<SetPreset>(&job)) {
        steps = preset(set->value.value_or(0));
    }
    return steps;
}

// Scaling and measuring range are read first, since they narrow what may be set (esc_job.cpp). The preset
// value is read before and after, so that a command that was carried out without an answer can be told from
// one that never arrived.
EscSteps EscPlan::preset(std::int64_t position) const
{
    using enum EscStep::Task;
    EscStep set = step(write, esc::Command::writePreset, static_cast<std::uint32_t>(position));
    set.value = position;
    EscStep after = step(positionAfter, esc::Command::position);
    after.value = position;
    EscSteps steps;
    const auto appendRefresh = [&](Parameter parameter) {
        if (const ParameterDescription *value = m_device.find(parameter); value && value->canBeRead)
            steps.push_back(reading(refresh, parameter));
    };
    for (const Parameter parameter : {Parameter::scaling, Parameter::measuringRange, Parameter::preset})
        appendRefresh(parameter);
    steps.push_back(step(positionBefore, esc::Command::position));
    steps.push_back(set);
    appendRefresh(Parameter::preset);
    steps.push_back(after);
    return steps;
}

ParameterValues EscPlan::completed(const ParameterValues &values) const
{
    ParameterValues all = values;
    const ParameterDescription *description = m_device.find(Parameter::scalingFactor);
    const bool canBeTold = description != nullptr && description->canBeWritten;
    if (canBeTold && !valueOf(values, Parameter::scalingFactor))
        if (const auto factor = escScalingFactorFor(values, m_known, m_settings.fractionBits))
            all.push_back({Parameter::scalingFactor, *factor});
    return all;
}

EscSteps EscPlan::writes(const ParameterValues &values) const
{
    const ParameterValues all = completed(values);
    if (all.empty())
        return {};
    EscSteps steps{step(EscStep::Task::positionBefore, esc::Command::position)};
    bool isScalingDone = false;
    for (const ParameterValue &value : all) {
        if (movesTheEncoder(value.parameter))
            continue;
        if (!isEscScaling(value.parameter)) {
            steps.push_back(writing(value));
            steps.push_back(readBack(steps.back()));
        } else if (!std::exchange(isScalingDone, true)) {
            appendScaling(steps, all);
        }
    }
    EscPlan there = *this;
    for (const Parameter last : {Parameter::lineAddress, Parameter::baudRate})
        if (const auto value = valueOf(all, last)) {
            steps.push_back(there.reading(EscStep::Task::refresh, Parameter::serialNumber));
            steps.push_back(there.writing({last, *value}));
            if (last == Parameter::lineAddress)
                there.m_address = {static_cast<std::uint8_t>(*value)};
            steps.push_back(there.readBack(steps.back()));
        }
    steps.push_back(there.step(EscStep::Task::positionAfter, esc::Command::position));
    return steps;
}

// The parts of it that are not written change all the same, so they are read.
void EscPlan::appendScaling(EscSteps &steps, const ParameterValues &values) const
{
    EscSteps after;
    const auto append = [&](Parameter parameter) {
        const ParameterDescription *description = m_device.find(parameter);
        if (description == nullptr)
            return;
        if (const auto value = valueOf(values, parameter)) {
            steps.push_back(writing({parameter, *value}));
            after.push_back(readBack(steps.back()));
        } else if (description->canBeRead) {
            after.push_back(reading(EscStep::Task::refresh, parameter));
        }
    };
    std::ranges::for_each(scalingValues, append);
    steps.insert(steps.end(), after.begin(), after.end());
}

EscStep EscPlan::readBack(const EscStep &write) const
{
    const Parameter parameter = write.parameter().value_or(Parameter::preset);
    EscStep step = movesTheEncoder(parameter) ? reading(EscStep::Task::search, Parameter::serialNumber)
                                              : reading(EscStep::Task::readBack, parameter);
    step.parameters = {parameter};
    step.value = write.value;
    return step;
}

void EscPlan::appendReads(EscSteps &steps, const std::vector<Parameter> &parameters) const
{
    for (const Parameter parameter : parameters)
        if (const ParameterDescription *description = m_device.find(parameter);
            description != nullptr && description->canBeRead)
            steps.push_back(reading(EscStep::Task::read, parameter));
}

EscStep EscPlan::reading(EscStep::Task task, Parameter parameter) const
{
    const ParameterDescription *description = m_device.find(parameter);
    const auto command = description != nullptr ? escReadCommand(*description) : std::nullopt;
    EscStep read = step(task, command.value_or(esc::Command::serialNumber));
    read.parameters = {parameter};
    return read;
}

EscStep EscPlan::writing(const ParameterValue &value) const
{
    const ParameterDescription &description = *m_device.find(value.parameter);
    EscStep write =
        step(EscStep::Task::write, escWriteCommand(description).value_or(esc::Command::writePreset),
             escData(description, value.value.number()));
    write.parameters = {value.parameter};
    write.value = value.value.number();
    return write;
}

EscStep EscPlan::step(EscStep::Task task, esc::Command command, std::uint32_t data) const
{
    EscStep step;
    step.task = task;
    step.request = {m_address, command, data};
    step.line = step.request.text();
    step.effect = esc::shapeOf(command).writes ? Effect::takes : Effect::reads;
    if (step.effect == Effect::takes)
        step.data = data;
    return step;
}

} // namespace codewheel
