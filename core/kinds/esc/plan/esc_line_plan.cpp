// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/plan/esc_line_plan.h"

#include "project/bus_kind.h"
#include "project/bus_plans.h"

namespace codewheel {

const EscLinePlan *linePlan(const Project &project, BusId line)
{
    const PlannedBus *planned = findBus(project, line);
    return planned ? planned->settings.as<EscLinePlan>() : nullptr;
}

void setLinePlan(Project &project, BusId line, EscLinePlan plan)
{
    planBus(project, line, *busKind(QString::fromLatin1(escKind))).settings = KindData(std::move(plan));
}

} // namespace codewheel
