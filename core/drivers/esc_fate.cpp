// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/esc_fate.h"

#include "drivers/esc_plan.h"
#include "drivers/values_to_write.h"

#include <algorithm>
#include <span>

namespace codewheel {
namespace {

// Whether it says of a write that was sent last that its outcome is not known.
bool leavesItOpen(const Refusal &why)
{
    return why.kind == RefusalKind::link || why.kind == RefusalKind::stopped || // ended where it stood
           why.id == RefusalId::escWriteUnknown || why.id == RefusalId::escNoAnswer ||
           why.id == RefusalId::escReadsDisagree;
}

} // namespace

bool wasSentOnEsc(const Progress &job, std::optional<Parameter> parameter)
{
    const auto begun =
        std::span(job.steps).first(std::min(job.steps.size(), static_cast<std::size_t>(job.index) + 1));
    return std::ranges::any_of(begun, [parameter](const Step &step) {
        return step.kind == StepKind::request && takesValue(step) && step.parameter == parameter;
    });
}

bool isFateUnknownOnEsc(const EncoderSession &encoder, std::optional<Parameter> parameter,
                        const Outcome &outcome, const Progress &job)
{
    if (outcome.result || !leavesItOpen(outcome.result.error()) || !wasSentOnEsc(job, parameter))
        return false;
    // Steps and range that are read do not tell whether new ones wait for their factor.
    const bool isUntold = parameter && outcome.result.error().id == RefusalId::escWriteUnknown &&
                          isBoundToEscFactor(*parameter);
    return isUntold || !encoder.known(parameter.value_or(Parameter::preset)); // which the position is
}

} // namespace codewheel
