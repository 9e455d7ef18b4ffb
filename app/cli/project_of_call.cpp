// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/project_of_call.h"

#include "bus/encoder_bus.h"
#include "cli/bus_access.h"
#include "cli/texts.h"
#include "encoder/bus_names.h"
#include "journal/ledger_keeper.h"
#include "project/project_file.h"
#include "transfer/project_places.h"

#include <QFileInfo>

#include <algorithm>

namespace codewheel {
namespace {

// One that nobody has named has its number.
QString nameOf(const Call &call, BusId bus)
{
    if (const BusAccess *access = call.findBus(bus))
        return access->name();
    const PlannedBus *planned = call.project != nullptr ? findBus(*call.project, bus) : nullptr;
    return planned != nullptr ? planned->name : QString::number(bus.number);
}

// Places of the same form may be the same on two buses.
QString formOf(NodeId node)
{
    for (const PlaceFormat &format : placeFormats())
        if (format.node(node.toString()))
            return QString::number(format.bus.number);
    return {};
}

} // namespace

Checked<std::optional<Project>> projectOf(const Subcommand &command, const Arguments &arguments)
{
    const auto option = arguments.value("--project");
    const bool isNamed = command.namesProject && !arguments.rest.isEmpty();
    if (!isNamed && !option)
        return std::nullopt;
    const QString file = isNamed ? arguments.rest.front() : *option;
    if (option && QFileInfo(*option).canonicalFilePath() != QFileInfo(file).canonicalFilePath())
        return badInput(QStringLiteral("twoProjects"),
                        CommandLine::tr("The call names two projects: %1 and %2. Leave --project out."),
                        {file, *option});
    return loadProject(file).map_error(complaintAbout).map([](Project &&project) {
        return std::optional(std::move(project));
    });
}

Checked<void> saveUnlessChanged(const Project &project, const QString &file, const QByteArray &mark)
{
    if (const auto saved = saveProjectOver(mark, project, file); !saved)
        return tl::unexpected(complaintAbout(saved.error()));
    return {};
}

void nameBuses(const Call &call, const Project &project)
{
    for (BusAccess *bus : call.links)
        if (const PlannedBus *planned = findBus(project, bus->bus().id());
            planned != nullptr && planned->kind == bus->kind())
            bus->setName(planned->name);
    BusNames::tell(call);
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
    std::vector<NamedBus> buses;
    for (const BusAccess *bus : call.links)
        buses.push_back({bus->bus().id(), bus->kind(), bus->name()});
    setBusNames(namesOfSeveral(buses), namesOf(buses));
}

void BusNames::tellApart(const Call &call, const std::set<Place> &places)
{
    std::map<BusId, NamedBus> buses;
    for (const Place &place : places) {
        NamedBus &bus = buses[place.bus];
        bus.id = place.bus;
        bus.name = nameOf(call, place.bus);
        if (!place.isEmpty())
            bus.kind = formOf(place.node);
    }
    std::vector<NamedBus> named;
    named.reserve(buses.size());
    for (const auto &[id, bus] : buses)
        named.push_back(bus);
    setBusNames(namesOfSeveral(named), named.size() > 1 ? namesOf(named) : std::map<BusId, QString>());
}

} // namespace codewheel
