// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/plc_words.h"

#include "jobs/protocol.h"
#include "jobs/values_to_write.h"
#include "kinds/interbus/words/la66_word.h"
#include "kinds/interbus/words/word_step.h"

namespace codewheel {
namespace {

// An LA-66 is read by services as well, which end with a word of their own.
bool onlyReads(const Step &step)
{
    if (step.kind == StepKind::readOut || step.kind == StepKind::endReadOut)
        return true;
    const bool isService = la66::service(step.out) != 0 &&
                           (step.kind == StepKind::service || step.kind == StepKind::serviceBit ||
                            step.kind == StepKind::toNormal);
    return isService && !la66::isWrite(step.out);
}

} // namespace

Result<std::vector<Word>> plcWords(const DeviceDescription &device, const ParameterValues &values,
                                   const std::vector<Known> &known)
{
    std::vector<Word> words;
    if (!device.hasWords() || values.empty())
        return words;
    const WriteParameters job{.values = inTurn(device, {.wanted = values}), .previous = {}};
    const auto steps = plannedSteps(device, job, {.known = known});
    if (!steps)
        return tl::unexpected(steps.error());
    for (const Step &step : *steps)
        if (!onlyReads(step))
            words.push_back(step.out);
    return words;
}

} // namespace codewheel
