// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/handshake_record.h"

#include "catalog/device_description.h"
#include "jobs/values_to_write.h"

#include <algorithm>

namespace codewheel {

bool HandshakeRecord::hasTaken() const
{
    const auto end =
        progress.steps.begin() + std::min<std::ptrdiff_t>(progress.index, std::ssize(progress.steps));
    return !progress.confirmed.empty() ||
           std::any_of(progress.steps.begin(), end, [](const Step &step) { return takesValue(step); });
}

ParameterValues HandshakeRecord::taken() const
{
    ParameterValues values;
    for (int i = 0; i < progress.index && i < static_cast<int>(progress.steps.size()); ++i) {
        const Step &step = progress.steps[static_cast<std::size_t>(i)];
        if (!writesValue(step))
            continue;
        for (const Parameter parameter : step.parameters)
            if (const auto value = findValue(job.values, parameter))
                values.push_back({parameter, *value});
    }
    return values;
}

void HandshakeRecord::takePositions(const Outcome &last)
{
    if (!recovery)
        positionBefore = last.positionBefore;
    positionAfter = last.positionAfter;
}

} // namespace codewheel
