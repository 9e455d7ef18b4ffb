// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/la66/la66_plan.h"

#include "jobs/job_check.h"
#include "kinds/interbus/words/la66_word.h"
#include "kinds/interbus/words/word_reach.h"

namespace codewheel {
namespace {

void append(La66Steps &steps, const La66Steps &more)
{
    steps.insert(steps.end(), more.begin(), more.end());
}

// Service and data, then the service bit, then the service bit back.
La66Steps service(Word request, const std::vector<Parameter> &parameters)
{
    La66Step data;
    data.kind = StepKind::service;
    data.out = request;
    data.parameters = parameters;
    La66Step bit = data;
    bit.kind = StepKind::serviceBit;
    bit.out = request | la66::serviceBit;
    bit.effect = effectOf(StepKind::serviceBit, bit.out);
    La66Step end = La66Plan::endOfService(request);
    end.parameters = parameters;
    if (bit.effect ==
        Effect::reads) // an LA-66 is read by services as well, with their words before and after
        data.effect = end.effect = Effect::reads;
    return {data, bit, end};
}

La66Steps writing(const ParameterDescription &parameter, std::int64_t value)
{
    La66Steps steps =
        service(la66::writeWord(wordReach(parameter).number.value_or(0), static_cast<Word>(value)),
                {parameter.parameter});
    steps[1].value = value;
    return steps;
}

La66Steps reading(const ParameterDescription &parameter, std::optional<std::int64_t> expected = {})
{
    La66Steps steps =
        service(la66::readWord(wordReach(parameter).readOut.value_or(0)), {parameter.parameter});
    steps[1].expected = expected;
    return steps;
}

La66Step wordStep(Word out, int holdCycles)
{
    La66Step step;
    step.kind = StepKind::word;
    step.effect = effectOf(StepKind::word, out);
    step.out = out;
    step.holdCycles = holdCycles;
    return step;
}

} // namespace

La66Step La66Plan::endOfService(Word out)
{
    La66Step step;
    step.kind = StepKind::toNormal;
    step.out = out & ~la66::serviceBit;
    return step;
}

La66Steps La66Plan::wayBack(Word out)
{
    La66Steps steps;
    if (out != la66::normalMode)
        steps.push_back(endOfService(out));
    steps.push_back(endOfService(la66::normalMode));
    return steps;
}

Result<void> La66Plan::check(const Job &job) const
{
    const auto *preset = std::get_if<SetPreset>(&job);
    if (auto checked = checkJob(m_device, job); !checked || preset == nullptr)
        return checked;
    if (*preset->value < 0 || *preset->value > std::int64_t{la66::dataMask})
        return refuse(RefusalKind::badInput, RefusalId::valueOutOfRange,
                      {Parameter::preset, *preset->value, std::int64_t{0}, std::int64_t{la66::dataMask}});
    return {};
}

La66Steps La66Plan::stepsFor(const Job &job, Word out) const
{
    if (const auto *send = std::get_if<SendWords>(&job))
        return words(*send, out);
    La66Steps steps;
    if (const auto *read = std::get_if<ReadParameters>(&job)) {
        steps = reads(read->parameters);
    } else if (const auto *write = std::get_if<WriteParameters>(&job)) {
        if (write->onlyWhatDiffers) {
            std::vector<Parameter> parameters;
            for (const ParameterValue &value : write->values)
                parameters.push_back(value.parameter);
            steps = reads(parameters);
        }
        append(steps, writes(write->values));
    } else if (const auto *preset = std::get_if<SetPreset>(&job)) {
        const auto position = static_cast<Word>(preset->value.value_or(0));
        steps = service(la66::writeWord(la66::presetAdjustment, position), {});
    } else if (const auto *end = std::get_if<EndParameterization>(&job)) {
        steps = writes(end->restore);
    }
    append(steps, wayBack(la66::normalMode));
    return steps;
}

La66Steps La66Plan::reads(const std::vector<Parameter> &parameters) const
{
    La66Steps steps;
    for (const Parameter parameter : parameters)
        if (const ParameterDescription *description = m_device.find(parameter);
            description != nullptr && description->canBeRead)
            append(steps, reading(*description));
    return steps;
}

// Each is read back where it can be.
La66Steps La66Plan::writes(const ParameterValues &values) const
{
    La66Steps steps;
    for (const ParameterValue &value : values) {
        const ParameterDescription &parameter = *m_device.find(value.parameter);
        append(steps, writing(parameter, value.value.number()));
        if (parameter.canBeRead)
            append(steps, reading(parameter, value.value.number()));
    }
    return steps;
}

// The words of the user as they are. What the handshake needs in between is inserted: service bit and data
// never change in the same cycle, and the rest of a word stays until the encoder is back in normal mode.
La66Steps La66Plan::words(const SendWords &job, Word out) const
{
    La66Steps steps;
    Word last = out;
    for (const Word word : job.words) {
        const Word withoutBit = word & ~la66::serviceBit;
        if (la66::isServiceMode(word)) {
            if (la66::isServiceMode(last) && word != last)
                steps.push_back(endOfService(last));
            if (word == last) {
                steps.push_back(wordStep(word, job.holdCycles));
            } else {
                La66Steps asked = service(withoutBit, {});
                const bool stoodBefore =
                    !steps.empty() && last == withoutBit && job.holdCycles >= m_timing.dataCycles;
                steps.insert(steps.end(), asked.begin() + (stoodBefore ? 1 : 0), asked.end() - 1);
            }
        } else {
            if (la66::isServiceMode(last))
                steps.push_back(endOfService(last));
            if (!la66::isServiceMode(last) || withoutBit != (last & ~la66::serviceBit))
                steps.push_back(wordStep(word, job.holdCycles));
        }
        last = word;
    }
    return steps;
}

} // namespace codewheel
