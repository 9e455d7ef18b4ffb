// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_range.h"

#include "catalog/total_range.h"
#include "jobs/value_notes.h"
#include "jobs/values_to_write.h"
#include "project/project.h"

namespace codewheel {
namespace {

ParameterValues plannedValues(const ProjectDevice &planned)
{
    ParameterValues values;
    for (const StoredValue &stored : planned.stored)
        values.push_back({stored.parameter, stored.value});
    for (const ParameterValue &wanted : planned.wanted)
        replaceValue(values, wanted);
    return values;
}

} // namespace

std::optional<std::int64_t> largestPosition(const ShownEncoder &encoder, const ProjectDevice &planned)
{
    const auto total = totalRange(encoder.device(), encoder.session() ? valuesOf(allKnown(*encoder.session()))
                                                                      : plannedValues(planned));
    return total ? std::optional(*total - 1) : std::nullopt;
}

} // namespace codewheel
