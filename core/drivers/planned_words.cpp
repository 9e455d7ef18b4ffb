// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/planned_words.h"

#include "drivers/k3_plan.h"
#include "drivers/la66_plan.h"

namespace codewheel {
namespace {

template <typename Plan, typename MakeSteps>
Result<std::vector<Step>> stepsOf(const Plan &plan, const Job &job, MakeSteps make)
{
    if (const auto checked = plan.check(job); !checked)
        return tl::unexpected(checked.error());
    const auto steps = make();
    return std::vector<Step>(steps.begin(), steps.end());
}

} // namespace

Result<std::vector<Step>> plannedSteps(const DeviceDescription &device, const std::vector<Known> &known,
                                       const Job &job, const std::vector<KnownCams> &cams, Word out)
{
    if (device.profile == Profile::la66) {
        const La66Plan plan(device, {});
        return stepsOf(plan, job, [&] { return plan.stepsFor(job, out); });
    }
    K3Knowledge knowledge(device);
    knowledge.set(known);
    knowledge.setCams(cams);
    const K3Plan plan(device, knowledge);
    return stepsOf(plan, job, [&] {
        K3Steps steps = plan.stepsFor(job);
        if (out != k3::normalRunning)
            K3Plan::clearOutFirst(steps, job);
        return steps;
    });
}

} // namespace codewheel
