// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/project_take_over.h"

#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/take_over.h"

namespace codewheel {
namespace {

ProjectDevice inThePlaceOf(const ProjectDevice &before)
{
    ProjectDevice device;
    device.station = before.station;
    device.group = before.group;
    device.note = before.note;
    device.settings = before.settings;
    return device;
}

} // namespace

RingStructure structureOf(const Project &project, BusId ring)
{
    return ringStructure(participantsOn(project, ring));
}

Project projectOf(const RingStructure &ring, BusId id)
{
    Project project;
    setRingPlan(project, id, {});
    for (const RingDevice &participant : ring) {
        ProjectDevice device;
        device.bus = id;
        device.participant = participant;
        project.devices.push_back(std::move(device));
    }
    return project;
}

Project takenOver(Project project, const RingStructure &connected, const Comparison &comparison,
                  std::span<const std::size_t> lines, BusId ring)
{
    setRingPlan(project, ring, ringPlan(project, ring));
    const RingStructure configured = structureOf(project, ring);
    const std::span<ProjectDevice> own = devicesOn(project, ring);
    std::vector<ProjectDevice> devices;
    DeviceNumber number;
    for (const TakenDevice &taken : takeOver(comparison, lines)) {
        const RingDevice participant = takenParticipant(taken, configured, connected);
        ProjectDevice device;
        if (taken.own) {
            ProjectDevice &before = own[*taken.own];
            const bool isSame = isSameKind(ringDevice(before.participant), participant);
            device = isSame ? std::move(before) : inThePlaceOf(before);
        }
        device.bus = ring;
        device.participant = participant;
        number = nextNumber(number, isOnLocalBus(participant));
        device.participant.number = number.node();
        devices.push_back(std::move(device));
    }
    setDevicesOn(project, ring, std::move(devices));
    return project;
}

} // namespace codewheel
