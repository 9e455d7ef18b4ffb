// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/ring_plan.h"

#include "project/bus_kind.h"
#include "project/bus_plans.h"

namespace codewheel {

std::vector<PlannedBus> usualBuses()
{
    return {{.id = firstBus,
             .kind = QString::fromLatin1(interbusKind),
             .name = QStringLiteral("Ring"),
             .settings = KindData(RingPlan())}};
}

const RingPlan &ringPlan(const Project &project, BusId ring)
{
    static const RingPlan usual;
    const PlannedBus *planned = findBus(project, ring);
    const RingPlan *plan = planned ? planned->settings.as<RingPlan>() : nullptr;
    return plan ? *plan : usual;
}

// Positions of simulated encoders say nothing about those of a real ring.
void setRingPlan(Project &project, BusId ring, RingPlan plan)
{
    if (plansTraining(project, ring) && plan.link.kind != ProjectLink().kind)
        for (ProjectDevice &device : project.devices)
            if (device.bus == ring)
                device.lastPosition.reset();
    planBus(project, ring, *busKind(QString::fromLatin1(interbusKind))).settings = KindData(std::move(plan));
}

} // namespace codewheel
