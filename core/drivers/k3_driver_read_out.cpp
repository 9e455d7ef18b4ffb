// SPDX-License-Identifier: GPL-3.0-or-later
// What a job does with a value it has read: checks it, or makes the rest of the plan shorter.
#include "drivers/k3_driver.h"

#include <algorithm>

namespace codewheel {

void K3Driver::readDone(const K3Step &step, Word in)
{
    const auto value = m_knowledge.valueOfReadOut(*step.parameter, k3::data(in));
    if (!value)
        return;
    if (step.expected) {
        verify(step, *value);
        return;
    }
    replaceValue(m_run->read, {*step.parameter, *value});
    replaceValue(m_run->before, {*step.parameter, *value});
    refine(*step.parameter, *value);
}

// A difference is a failure, but the others are read all the same, so that what the encoder has is known.
void K3Driver::verify(const K3Step &step, std::int64_t value)
{
    Run &run = *m_run;
    if (value == *step.expected) {
        if (!valueOf(run.alreadyThere, *step.parameter))
            replaceValue(run.written, {*step.parameter, value});
        return;
    }
    std::erase_if(run.written, [&](const ParameterValue &one) { return one.parameter == *step.parameter; });
    if (!run.mismatch)
        run.mismatch = {
            RefusalKind::device, RefusalId::verificationFailed, {*step.parameter, *step.expected, value}};
}

// A value that was read changes the rest of the plan: what is already there is left out, steps are sent minus
// 1 where the encoder counts so, and a preset is programmed again only where it is used up.
void K3Driver::refine(Parameter parameter, std::int64_t value)
{
    Run &run = *m_run;
    const auto rest = run.steps.begin() + static_cast<std::ptrdiff_t>(run.index);
    const auto *preset = std::get_if<SetPreset>(&run.job);
    const bool isProfilePreset =
        initialisesPreset(run.job) && !(preset != nullptr && preset->command == PresetCommand::manufacturer);
    const bool rearms = parameter == Parameter::preset && isProfilePreset &&
                        m_device.quirks.presetNeedsRearming &&
                        valueOf(run.read, Parameter::presetFlag).value_or(0) == 0;

    const bool keepsValue = preset != nullptr && !preset->value && parameter == Parameter::preset;
    for (auto step = rest; step != run.steps.end(); ++step) {
        if (step->kind != StepKind::parameter || !step->parameter)
            continue;
        if (keepsValue && step->parameter == parameter)
            step->value = value;
        step->out = m_plan.parameterWord(*step->parameter, step->value);
    }
    const auto *write = std::get_if<WriteParameters>(&run.job);
    if (!rearms && (preset != nullptr || (write != nullptr && write->onlyWhatDiffers)))
        leaveOut(parameter, value);
}

void K3Driver::leaveOut(Parameter parameter, std::int64_t value)
{
    Run &run = *m_run;
    const auto rest = [&] { return run.steps.begin() + static_cast<std::ptrdiff_t>(run.index); };
    const auto write = std::find_if(rest(), run.steps.end(), [&](const K3Step &step) {
        return step.kind == StepKind::parameter && step.parameter == parameter && step.value == value;
    });
    if (write == run.steps.end())
        return;
    run.steps.erase(write);
    replaceValue(run.alreadyThere, {parameter, value});
    const auto verify = std::find_if(rest(), run.steps.end(), [&](const K3Step &step) {
        return step.parameter == parameter && step.expected.has_value();
    });
    if (verify != run.steps.end())
        run.steps.erase(verify, verify + 2); // with the end of its read-out

    const auto isWrite = [](const K3Step &step) { return step.kind == StepKind::parameter; };
    if (std::any_of(rest(), run.steps.end(), isWrite))
        return;
    const auto runStep =
        std::find_if(rest(), run.steps.end(), [](const K3Step &s) { return s.kind == StepKind::run; });
    if (runStep != run.steps.end())
        run.steps.erase(runStep, runStep + 2); // with the 00000000 behind it
}

} // namespace codewheel
