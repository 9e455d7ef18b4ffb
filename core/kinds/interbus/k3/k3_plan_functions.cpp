// SPDX-License-Identifier: GPL-3.0-or-later
// The functions beside parameters: modes, the FRABA preset, the reset to factory settings.
#include "jobs/job_check.h"
#include "kinds/interbus/k3/k3_cam_plan.h"
#include "kinds/interbus/k3/k3_plan.h"
#include "kinds/interbus/words/k3_cam_word.h"

namespace codewheel {

K3Step K3Plan::switchStep(Word modeWord)
{
    K3Step step = k3Step(StepKind::switchMode, modeWord);
    step.holdCycles = K3Mode::cyclesUntilTaken;
    return step;
}

Result<void> K3Plan::checkPreset(const SetPreset &job) const
{
    const ParameterDescription *preset = m_device.find(Parameter::preset);
    if (!preset || !preset->canBeWritten)
        return refuse(RefusalKind::notSupported, RefusalId::presetNotSupported, {m_device.fullName()});
    if (job.value)
        return checkValue(m_device, {Parameter::preset, *job.value});
    const bool isReadFirst = m_device.quirks.presetNeedsRearming && job.command == PresetCommand::profile;
    if (isReadFirst && !preset->canBeRead) // there is no value to program again
        return refuse(RefusalKind::badInput, RefusalId::presetNeedsValue, {m_device.fullName()});
    return {};
}

K3Steps K3Plan::plan(const SwitchMode &job) const
{
    if (job.mode == Mode::cam)
        return K3CamPlan(m_device, m_knowledge).stepsFor(job);
    K3Steps steps;
    if (job.mode == Mode::position || m_knowledge.mode() == Mode::cam)
        appendPositionMode(steps);
    if (job.mode == Mode::velocity)
        steps.push_back(switchStep(k3::velocityOn));
    steps.push_back(toNormal(false));
    return steps;
}

// 20800000h has the same meaning in every mode: it ends cam mode. After it, 20400000h cannot switch cams off.
void K3Plan::appendPositionMode(K3Steps &steps) const
{
    const auto mode = m_knowledge.mode();
    if (mode != Mode::position && mode != Mode::velocity)
        steps.push_back(switchStep(k3::programWord));
    if (mode != Mode::cam)
        steps.push_back(switchStep(k3::velocityOff));
}

K3Steps K3Plan::plan(const ReadCams &job) const
{
    return K3CamPlan(m_device, m_knowledge).stepsFor(job);
}

K3Steps K3Plan::plan(const WriteCams &job) const
{
    return K3CamPlan(m_device, m_knowledge).stepsFor(job);
}

// A preset programmed once can be activated any number of times (FRABA manual 5.4.1), so a value that is
// already there is not programmed again.
K3Steps K3Plan::manufacturerPreset(std::optional<std::int64_t> value) const
{
    K3Steps steps;
    if (value)
        steps = plan(WriteParameters{.values = {{Parameter::preset, *value}},
                                     .onlyWhatDiffers = true,
                                     .previous = {},
                                     .initialisePreset = false});
    appendPresetRead(steps);
    steps.push_back(k3Step(StepKind::manufacturerPreset, k3::frabaPreset));
    steps.push_back(toNormal(true));
    return steps;
}

// Cam mode refuses parameter words, and velocity mode is left so that it is certain what the encoder shows
// afterwards.
K3Steps K3Plan::plan(const ResetToDefault &) const
{
    K3Steps steps;
    if (m_device.quirks.hasModes && m_knowledge.mode() != Mode::position) {
        appendPositionMode(steps);
        steps.push_back(toNormal(false));
    }
    steps.push_back(k3Step(StepKind::parameter, k3::parameterWord(resetNumber, 0)));
    steps.push_back(runStep(false));
    steps.push_back(toNormal(true));
    if (m_device.quirks.mayCountStepsMinusOne)
        appendRead(steps, Parameter::multiTurnAndStepsMinusOne);
    for (const ParameterDescription &parameter : m_device.parameters)
        if (parameter.canBeWritten)
            appendRead(steps, parameter.parameter);
    return steps;
}

} // namespace codewheel
