// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/project_of_call.h"

#include "bus/encoder_bus.h"
#include "cli/bus_access.h"
#include "journal/ledger_keeper.h"
#include "project/project_file.h"
#include "transfer/project_places.h"

#include <QFileInfo>

#include <algorithm>

namespace codewheel {
namespace {

void nameBuses(const Call &call, const Project &project)
{
    for (BusAccess *bus : call.links)
        if (const PlannedBus *planned = findBus(project, bus->bus().id());
            planned != nullptr && planned->kind == bus->kind())
            bus->setName(planned->name);
    BusNames::tell(call);
}

} // namespace

Checked<std::optional<Project>> projectNamed(const Arguments &arguments)
{
    const auto file = arguments.value("--project");
    if (!file)
        return std::nullopt;
    auto project = loadProject(*file);
    if (!project)
        return tl::unexpected(complaintAbout(project.error()));
    return *std::move(project);
}

Checked<void> saveUnlessChanged(const Project &project, const QString &file, const QByteArray &mark)
{
    if (const auto saved = saveProjectOver(mark, project, file); !saved)
        return tl::unexpected(complaintAbout(saved.error()));
    return {};
}

void useProject(const Call &call, const Project &project, const QString &file)
{
    nameBuses(call, project);
    for (BusAccess *bus : call.links)
        bus->useProject(call, project);
    const ProjectPlaces places(project, call.buses);
    for (const BusAccess *bus : call.links) {
        LedgerKeeper *ledger = bus->ledger();
        if (ledger == nullptr)
            continue;
        ledger->setProject(QFileInfo(file).absoluteFilePath());
        for (const ProjectDevice &device : devicesOn(project, bus->bus().id()))
            if (!bus->bus().isOpen() || places.isAtItsPlace(device.place()))
                ledger->setLabel(device.place(), device.label.serialNumber);
    }
}

BusNames::BusNames(const Call &call)
{
    tell(call);
}

BusNames::~BusNames()
{
    setBusNames({});
}

void BusNames::tell(const Call &call)
{
    std::map<BusId, QString> names;
    for (const BusAccess *bus : call.links)
        if (std::ranges::count(call.links, bus->kind(), &BusAccess::kind) > 1)
            names[bus->bus().id()] = bus->name();
    setBusNames(std::move(names));
}

} // namespace codewheel
