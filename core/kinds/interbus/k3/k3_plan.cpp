// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_plan.h"

#include "jobs/job_check.h"
#include "kinds/interbus/k3/k3_cam_plan.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/word_reach.h"

#include <algorithm>

namespace codewheel {

Result<void> K3Plan::check(const Job &job) const
{
    if (auto checked = checkJob(m_device, job); !checked)
        return checked;
    if (const auto *preset = std::get_if<SetPreset>(&job))
        return checkPreset(*preset);
    const K3CamPlan camPlan(m_device, m_knowledge);
    if (const auto *to = std::get_if<SwitchMode>(&job))
        return camPlan.check(*to);
    if (const auto *cams = std::get_if<ReadCams>(&job))
        return camPlan.check(*cams);
    if (const auto *cams = std::get_if<WriteCams>(&job))
        return camPlan.check(*cams);
    return {};
}

K3Steps K3Plan::stepsFor(const Job &job) const
{
    return std::visit(
        [this](const auto &one) {
            if constexpr (requires { plan(one); })
                return plan(one);
            else
                return K3Steps(); // check() refuses what only other kinds have
        },
        job);
}

K3Steps K3Plan::plan(const ReadParameters &job) const
{
    K3Steps steps;
    const bool readsSteps = std::ranges::find(job.parameters, Parameter::steps) != job.parameters.end();
    if (readsSteps && !m_knowledge.countsStepsMinusOne())
        appendRead(steps, Parameter::multiTurnAndStepsMinusOne);
    for (const Parameter parameter : job.parameters)
        appendRead(steps, parameter);
    return steps;
}

K3Steps K3Plan::plan(const WriteParameters &job) const
{
    K3Steps steps;
    if (needsStepsFlag(job.values))
        appendRead(steps, Parameter::multiTurnAndStepsMinusOne);
    if (job.onlyWhatDiffers && m_device.capabilities.reads) {
        if (job.initialisePreset && m_device.quirks.presetNeedsRearming &&
            valueOf(job.values, Parameter::preset))
            appendRead(steps, Parameter::presetFlag);
        for (const ParameterValue &value : job.values)
            appendRead(steps, value.parameter);
    }
    appendWrites(steps, job.values);
    if (job.initialisePreset)
        appendPreset(steps);
    for (const ParameterValue &value : job.values)
        appendRead(steps, value.parameter, value.value.number());
    return steps;
}

// 40000000h. FRABA: a programmed preset can be activated once. If no value is given, the encoder's own is
// programmed again if the flag says that it is used up; which one that is, is read.
K3Steps K3Plan::plan(const SetPreset &job) const
{
    if (job.command == PresetCommand::manufacturer)
        return manufacturerPreset(job.value);
    if (job.value)
        return plan(WriteParameters{.values = {{Parameter::preset, *job.value}},
                                    .onlyWhatDiffers = true,
                                    .previous = {},
                                    .initialisePreset = true});
    K3Steps steps;
    if (m_device.quirks.presetNeedsRearming && m_device.capabilities.reads) {
        appendRead(steps, Parameter::presetFlag);
        appendRead(steps, Parameter::preset);
        appendWrites(steps, {{Parameter::preset, m_knowledge.value(Parameter::preset).value_or(0)}});
    }
    appendPreset(steps);
    return steps;
}

K3Steps K3Plan::plan(const SendWords &job) const
{
    K3Steps steps;
    for (const Word word : job.words) {
        K3Step step = k3Step(StepKind::word, word);
        step.holdCycles = job.holdCycles;
        step.standsUntilItActs = job.presetStandsUntilItActs && word == k3::initialisePreset;
        if (k3::isParameterWord(word))
            if (const ParameterDescription *parameter = findNumber(m_device, k3::number(word)))
                step.parameters = {parameter->parameter};
        steps.push_back(step);
    }
    return steps;
}

K3Steps K3Plan::plan(const EndParameterization &job) const
{
    return endParameterization(job.restore, true);
}

// FRABA's manual does not forbid a number to come again in the same parameterization, so earlier values go
// out before anything else becomes valid (assumed). Baumer's forbids it.
K3Steps K3Plan::endParameterization(const ParameterValues &restore, bool runFirst) const
{
    K3Steps steps;
    const bool isRepeated =
        !restore.empty() && m_device.dialect == k3::Dialect::fraba && !needsStepsFlag(restore);
    if (runFirst && !isRepeated)
        steps = {runStep(!restore.empty()), toNormal(restore.empty())};
    if (needsStepsFlag(restore))
        appendRead(steps, Parameter::multiTurnAndStepsMinusOne);
    appendWrites(steps, restore);
    for (K3Step &step : steps)
        step.isRepeated = runFirst && isRepeated && step.kind == StepKind::parameter;
    for (const ParameterValue &value : restore)
        appendRead(steps, value.parameter, value.value.number());
    return steps;
}

K3Step K3Plan::runStep(bool tolerateError)
{
    K3Step step = k3Step(StepKind::run, k3::run);
    step.tolerateError = tolerateError;
    return step;
}

void K3Plan::clearOutFirst(K3Steps &steps, const Job &job)
{
    if (!std::holds_alternative<SendWords>(job))
        steps.insert(steps.begin(), toNormal(false));
}

K3Step K3Plan::toNormal(bool mustOperate)
{
    K3Step step = k3Step(StepKind::toNormal, k3::normalRunning);
    step.mustOperate = mustOperate;
    return step;
}

Word K3Plan::parameterWord(Parameter parameter, std::int64_t value) const
{
    return k3::parameterWord(wordReach(*m_device.find(parameter)).number.value_or(0),
                             m_knowledge.dataFor(parameter, value));
}

bool K3Plan::needsStepsFlag(const ParameterValues &values) const
{
    return valueOf(values, Parameter::steps) && !m_knowledge.countsStepsMinusOne() &&
           m_device.capabilities.reads;
}

void K3Plan::appendRead(K3Steps &steps, Parameter parameter, std::optional<std::int64_t> expected) const
{
    const ParameterDescription *description = m_device.find(parameter);
    if (description == nullptr || !description->canBeRead)
        return;
    K3Step read = k3Step(StepKind::readOut, k3::readOutWord(*wordReach(*description).readOut));
    read.parameters = {parameter};
    read.expected = expected;
    steps.push_back(read);
    steps.push_back(k3Step(StepKind::endReadOut, k3::normalRunning));
}

void K3Plan::appendWrites(K3Steps &steps, const ParameterValues &values) const
{
    if (values.empty())
        return;
    for (const ParameterValue &value : values) {
        K3Step step = k3Step(StepKind::parameter, parameterWord(value.parameter, value.value.number()));
        step.parameters = {value.parameter};
        step.value = value.value.number();
        steps.push_back(step);
    }
    steps.push_back(runStep(false));
    steps.push_back(toNormal(true));
}

// Which value that is has to be known: the position then proves that it was taken.
void K3Plan::appendPresetRead(K3Steps &steps) const
{
    const bool isKnown =
        m_knowledge.value(Parameter::preset) ||
        std::ranges::any_of(steps, [](const K3Step &step) { return step.parameter() == Parameter::preset; });
    if (!isKnown)
        appendRead(steps, Parameter::preset);
}

void K3Plan::appendPreset(K3Steps &steps) const
{
    appendPresetRead(steps);
    steps.push_back(k3Step(StepKind::initialisePreset, k3::initialisePreset));
    steps.push_back(toNormal(true));
}

} // namespace codewheel
