// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/completion/known_devices.h"

#include "project/bus_kind.h"
#include "project/project_file.h"
#include "user_devices.h"

#include <algorithm>

namespace codewheel {
namespace {

const QString training = QStringLiteral("training");

Catalog catalogOfUser()
{
    Catalog catalog = Catalog::builtIn();
    addUserDevices(catalog, userDeviceFolder()); // a call that is carried out reports what is wrong
    return catalog;
}

std::optional<Project> projectIn(const QString &file)
{
    if (file.isEmpty())
        return std::nullopt;
    auto project = loadProject(file);
    return project ? std::optional(*std::move(project)) : std::nullopt;
}

bool hasScheme(const LinkKind &kind, const QString &link)
{
    const auto text = LinkText::parse(link);
    return text && text->where == training && kind.schemes().contains(text->scheme);
}

// "Ring/1.0" and "esc:05" are 1.0 and 05.
QString withoutBus(const QString &place)
{
    return place.section(u'/', -1).section(u':', -1);
}

} // namespace

KnownDevices::KnownDevices(const QString &link, const QString &projectFile)
    : m_catalog(catalogOfUser())
    , m_project(projectIn(projectFile))
{
    const bool isTraining = link == training || link.endsWith(u':' + training);
    if (isTraining)
        addTraining(link);
    if (m_project)
        addPlanned(!isTraining);
}

void KnownDevices::addTraining(const QString &link)
{
    for (const LinkKind *kind : linkKinds())
        if (link == training ? static_cast<bool>(kind->training(nullptr)) : hasScheme(*kind, link))
            std::ranges::copy(kind->trainingDevices(m_catalog), std::back_inserter(m_devices));
}

void KnownDevices::addPlanned(bool leadsToPlan)
{
    if (leadsToPlan)
        for (const ProjectDevice &device : m_project->devices)
            m_devices.push_back({device.place().toString(), device.participant.deviceKey});
    for (const ProjectDevice &device : m_project->devices)
        if (!device.station.isEmpty())
            m_devices.push_back({device.station, device.participant.deviceKey});
}

QStringList KnownDevices::buses() const
{
    QStringList names;
    if (m_project)
        for (const PlannedBus &bus : m_project->buses)
            names << bus.name;
    else
        for (const LinkKind *kind : linkKinds())
            names << busKind(kind->bus())->usualName();
    names.removeDuplicates();
    return names;
}

std::vector<const ParameterDescription *> KnownDevices::parameters(const QString &place) const
{
    auto found = std::ranges::find(m_devices, place, &KnownDevice::place);
    if (found == m_devices.end())
        found = std::ranges::find(m_devices, withoutBus(place),
                                  [](const KnownDevice &device) { return withoutBus(device.place); });
    const DeviceDescription *device = found != m_devices.end() ? m_catalog.find(found->key) : nullptr;
    std::vector<const ParameterDescription *> parameters;
    for (const DeviceDescription &each : m_catalog.devices())
        if (device == nullptr || device == &each)
            for (const ParameterDescription &parameter : each.parameters)
                parameters.push_back(&parameter);
    return parameters;
}

} // namespace codewheel
