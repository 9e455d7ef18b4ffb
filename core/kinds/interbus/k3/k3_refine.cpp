// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_refine.h"

#include <algorithm>

namespace codewheel {
namespace {

bool isWrite(const K3Step &step)
{
    return step.kind == StepKind::parameter;
}

// Neither written nor read back; if no write is left there is no run either.
void leaveOut(JobSteps<K3Step> &steps, ParameterValues &alreadyThere, ParameterValue value)
{
    std::vector<K3Step> &all = steps.all;
    const auto write = std::find_if(steps.rest(), all.end(), [&](const K3Step &step) {
        return isWrite(step) && step.parameter() == value.parameter && step.value == value.value;
    });
    if (write == all.end())
        return;
    all.erase(write);
    replaceValue(alreadyThere, value);
    const auto verify = std::find_if(steps.rest(), all.end(), [&](const K3Step &step) {
        return step.parameter() == value.parameter && step.expected.has_value();
    });
    if (verify != all.end())
        all.erase(verify, verify + 2); // including the end of its read-out

    if (std::any_of(steps.rest(), all.end(), isWrite))
        return;
    const auto run =
        std::find_if(steps.rest(), all.end(), [](const K3Step &s) { return s.kind == StepKind::run; });
    if (run != all.end())
        all.erase(run, run + 2); // including the 00000000 after it
}

} // namespace

void refine(JobSteps<K3Step> &steps, JobAccount &account, const Job &job, const K3Encoder &encoder,
            const ParameterValue &read)
{
    const auto *preset = std::get_if<SetPreset>(&job);
    const bool isPreset = read.parameter == Parameter::preset;
    const bool isProfilePreset =
        initialisesPreset(job) && !(preset != nullptr && preset->command == PresetCommand::manufacturer);
    const bool rearms = isPreset && isProfilePreset && encoder.device.quirks.presetNeedsRearming &&
                        valueOf(account.outcome.read, Parameter::presetFlag).value_or(0) == 0;

    const bool keepsValue = isPreset && preset != nullptr && !preset->value;
    for (auto step = steps.rest(); step != steps.all.end(); ++step) {
        if (!isWrite(*step) || !step->parameter())
            continue;
        if (keepsValue && step->parameter() == read.parameter)
            step->value = read.value.number();
        step->out = encoder.plan.parameterWord(*step->parameter(), step->value);
    }
    const auto *write = std::get_if<WriteParameters>(&job);
    if (!rearms && (preset != nullptr || (write != nullptr && write->onlyWhatDiffers)))
        leaveOut(steps, account.outcome.alreadyThere, read);
}

} // namespace codewheel
