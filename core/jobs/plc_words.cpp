// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/plc_words.h"

#include "jobs/protocol.h"
#include "jobs/values_to_write.h"

namespace codewheel {

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
        if (step.effect != Effect::reads)
            words.push_back(step.out);
    return words;
}

} // namespace codewheel
