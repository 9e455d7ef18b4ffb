// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/planned_words.h"

#include "drivers/esc_plan.h"
#include "drivers/k3_plan.h"
#include "drivers/la66_plan.h"
#include "drivers/value_notes.h"

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

// The encoder is where it is known to be, else at the master address.
Result<std::vector<Step>> escSteps(const DeviceDescription &device, const std::vector<Known> &known,
                                   const Job &job, const EscSettings &settings)
{
    const ParameterValues values = valuesOf(known);
    const auto address = valueOf(values, Parameter::lineAddress).value_or(LineAddress::master().value);
    const EscPlan plan(device, {static_cast<std::uint8_t>(address)}, settings, values);
    return stepsOf(plan, job, [&] { return plan.stepsFor(job); });
}

} // namespace

Result<std::vector<Step>> plannedSteps(const DeviceDescription &device, const std::vector<Known> &known,
                                       const Job &job, const std::vector<KnownCams> &cams, Word out,
                                       const EscSettings &escSettings)
{
    if (device.profile == Profile::la66) {
        const La66Plan plan(device, {});
        return stepsOf(plan, job, [&] { return plan.stepsFor(job, out); });
    }
    if (device.profile == Profile::esc)
        return escSteps(device, known, job, escSettings);
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
