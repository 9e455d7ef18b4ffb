// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/event.h"

#include <vector>

namespace codewheel {

// The steps of a job, unless its plan refuses it, as shown to whoever reviews them.
template <typename Plan, typename MakeSteps>
Result<std::vector<Step>> plannedBy(const Plan &plan, const Job &job, MakeSteps make)
{
    if (const auto checked = plan.check(job); !checked)
        return tl::unexpected(checked.error());
    const auto steps = make();
    return std::vector<Step>(steps.begin(), steps.end());
}

} // namespace codewheel
