// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_fate.h"

#include "jobs/values_to_write.h"
#include "kinds/esc/driver/esc_plan.h"
#include "kinds/esc/protocol/esc_refusals.h"

#include <algorithm>
#include <span>

namespace codewheel {
namespace {

// Whether it leaves open if the last write sent was carried out.
bool leavesItOpen(const Refusal &why)
{
    return why.kind == RefusalKind::link || why.kind == RefusalKind::stopped || // ended midway
           why.id == EscRefusalId::writeUnknown || why.id == RefusalId::escNoAnswer ||
           why.id == EscRefusalId::readsDisagree;
}

} // namespace

bool wasSentOnEsc(const Progress &job, std::optional<Parameter> parameter)
{
    const auto begun =
        std::span(job.steps).first(std::min(job.steps.size(), static_cast<std::size_t>(job.index) + 1));
    return std::ranges::any_of(
        begun, [parameter](const Step &step) { return takesValue(step) && step.parameter() == parameter; });
}

bool isFateUnknownOnEsc(const EncoderSession &encoder, std::optional<Parameter> parameter,
                        const Outcome &outcome, const Progress &job)
{
    if (outcome.result || !leavesItOpen(outcome.result.error()) || !wasSentOnEsc(job, parameter))
        return false;
    // Reading steps and range back does not tell whether new ones are still waiting for their factor.
    const bool isUntold = parameter && outcome.result.error().id == EscRefusalId::writeUnknown &&
                          isBoundToEscFactor(*parameter);
    // The position is known as the preset.
    return isUntold || !encoder.known(parameter.value_or(Parameter::preset));
}

} // namespace codewheel
