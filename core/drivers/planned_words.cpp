// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/planned_words.h"

#include "drivers/k3_plan.h"

namespace codewheel {

Result<std::vector<Step>> plannedSteps(const DeviceDescription &device, const std::vector<Known> &known,
                                       const Job &job, const std::vector<KnownCams> &cams)
{
    K3Knowledge knowledge(device);
    knowledge.set(known);
    knowledge.setCams(cams);
    const K3Plan plan(device, knowledge);
    if (const auto checked = plan.check(job); !checked)
        return tl::unexpected(checked.error());
    const K3Steps steps = plan.stepsFor(job);
    return std::vector<Step>(steps.begin(), steps.end());
}

} // namespace codewheel
