// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure_editor/plan_row.h"

#include "catalog/catalog.h"
#include "ring/id_code.h"
#include "ring/numbering.h"

namespace codewheel {
namespace {

const DeviceDescription *descriptionOf(const Participant &participant, const Catalog &catalog)
{
    const DeviceDescription *named = catalog.find(participant.deviceKey);
    return named ? named : catalog.generic(participant.deviceCode);
}

} // namespace

QString planName(const Participant &participant, const Catalog &catalog)
{
    if (const DeviceDescription *device = descriptionOf(participant, catalog))
        return device->fullName();
    const QString kind = idCodeName(participant.idCode);
    return kind.isEmpty() ? participantName(participant, nullptr) : kind;
}

bool prefersLocalBus(const Participant &participant)
{
    return isOnLocalBus(participant) || standsOnLocalBus(participant.idCode);
}

std::vector<PlanRow> planRows(const Project &project, BusId ring, const Catalog &catalog)
{
    const std::vector<DeviceAddresses> addresses = processAddresses(project, ring);
    std::vector<PlanRow> rows;
    const std::span<const ProjectDevice> devices = devicesOn(project, ring);
    rows.reserve(devices.size());
    for (std::size_t place = 0; place < devices.size(); ++place) {
        const ProjectDevice &device = devices[place];
        const DeviceDescription *described = descriptionOf(device.participant, catalog);
        rows.push_back({.place = device.place(),
                        .participant = device.participant,
                        .station = device.station,
                        .group = device.group,
                        .note = device.note,
                        .serialNumber = device.label.serialNumber,
                        .name = planName(device.participant, catalog),
                        .profile = described ? profileName(described->profile) : QString(),
                        .addresses = addresses[place],
                        .unit = ringPlan(project, ring).addresses.unit,
                        .findings = {}});
    }
    for (Finding &finding : checkProject(project, addresses, ring))
        rows[finding.device].findings.push_back(std::move(finding));
    // Where it stands is told by the row: the number goes on when a device before it is inserted.
    for (PlanRow &row : rows)
        for (Finding &finding : row.findings)
            finding.device = 0;
    return rows;
}

} // namespace codewheel
