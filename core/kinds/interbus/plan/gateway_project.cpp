// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/gateway_project.h"

#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/comparison.h"

#include <algorithm>

namespace codewheel {
namespace {

bool isAsPlanned(const RingStructure &planned, const RingStructure &offered)
{
    return std::ranges::equal(planned, offered, [](const RingDevice &one, const RingDevice &other) {
        return one.number == other.number && isSameKind(one, other);
    });
}

} // namespace

Project gatewayProject(const Project &planned, BusId ring, const RingStructure &offered,
                       const GatewaySettings &gateway, const QString &name)
{
    Project project = projectOf(offered);
    project.title = planned.title;
    if (isAsPlanned(structureOf(planned, ring), offered))
        std::ranges::copy(devicesOn(planned, ring), project.devices.begin());
    for (ProjectDevice &device : project.devices) {
        device.bus = firstBus;
        device.stored.clear();
        device.storedCams.clear();
        device.lastPosition.reset();
    }
    RingPlan plan = ringPlan(planned, ring);
    plan.link = {linkKindOf(gateway), linkTexts(gateway)};
    setRingPlan(project, firstBus, std::move(plan));
    findBus(project, firstBus)->name = name;
    return project;
}

} // namespace codewheel
