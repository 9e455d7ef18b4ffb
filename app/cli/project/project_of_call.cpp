// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/project/project_of_call.h"

#include "bus/encoder_bus.h"
#include "cli/bus/bus_access.h"
#include "cli/call/texts.h"
#include "cli/kinds/link_kind.h"
#include "journal/ledger_keeper.h"
#include "project/project_file.h"
#include "transfer/project_places.h"
#include "vocabulary/bus_names.h"

#include <QFileInfo>

#include <algorithm>

namespace codewheel {
namespace {

// Named by the call, otherwise by its project; empty: nobody has named it.
std::optional<NamedBus> namedBus(const Call &call, BusId bus)
{
    if (const BusAccess *access = call.findBus(bus))
        return NamedBus{bus, access->kind(), access->name()};
    const PlannedBus *planned = call.project != nullptr ? findBus(*call.project, bus) : nullptr;
    return planned != nullptr ? std::optional(NamedBus{bus, planned->kind, planned->name}) : std::nullopt;
}

QString nameOf(const Call &call, BusId bus)
{
    const auto named = namedBus(call, bus);
    return named ? named->name : QString::number(bus.number);
}

bool canHave(const NamedBus &bus, NodeId node)
{
    const auto kinds = linkKinds();
    const auto kind = std::ranges::find(kinds, bus.kind, &LinkKind::bus);
    return kind == kinds.end() || (*kind)->isPlace(node.toString());
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
        return badInput("twoProjects",
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
    std::map<std::pair<BusId, QString>, NamedBus> forms; // of places on a bus
    std::map<BusId, QString> names;
    for (const Place &place : places) {
        const QString name = names[place.bus] = nameOf(call, place.bus);
        if (place.isEmpty())
            continue;
        const QString form = formOf(place.node);
        forms[{place.bus, form}] = {place.bus, form, name};
    }
    std::vector<NamedBus> named;
    named.reserve(forms.size());
    for (const auto &[key, bus] : forms)
        named.push_back(bus);
    setBusNames(namesOfSeveral(named), names.size() > 1 ? names : std::map<BusId, QString>());
}

QString BusNames::apart(const Call &call, Place place, bool isOfProject)
{
    QString shown = place.shown();
    const auto bus = namedBus(call, place.bus);
    if (shown == place.toString() || !bus || (isOfProject && canHave(*bus, place.node)))
        return shown;
    return QStringLiteral("%1/%2").arg(place.bus.number).arg(place.toString());
}

} // namespace codewheel
