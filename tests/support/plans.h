// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/interbus/plan/ring_plan.h"

#include <utility>

namespace codewheel {

template <typename Change>
void changeRing(Project &project, Change change)
{
    RingPlan plan = ringPlan(project, firstBus);
    change(plan);
    setRingPlan(project, firstBus, std::move(plan));
}

// Plans the line if there is none.
template <typename Change>
void changeLine(Project &project, Change change)
{
    const EscLinePlan *planned = linePlan(project, firstLine);
    EscLinePlan plan = planned ? *planned : EscLinePlan();
    change(plan);
    setLinePlan(project, firstLine, std::move(plan));
}

inline std::vector<ProjectDevice> encodersOnLine(const Project &project)
{
    const auto encoders = devicesOn(project, firstLine);
    return {encoders.begin(), encoders.end()};
}
inline void setEncodersOnLine(Project &project, std::vector<ProjectDevice> encoders)
{
    changeLine(project, [](EscLinePlan &) {});
    for (ProjectDevice &encoder : encoders)
        encoder.bus = firstLine;
    setDevicesOn(project, firstLine, std::move(encoders));
}

} // namespace codewheel
