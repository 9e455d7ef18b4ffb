// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/palette_devices.h"

#include "bus/buses.h"
#include "catalog/catalog.h"
#include "project/project.h"
#include "widgets/project/project_document.h"
#include "widgets/structure/structure_view.h"

#include <utility>

namespace codewheel {
namespace {

QString joined(QStringList parts, const QString &between)
{
    parts.removeAll(QString());
    return parts.join(between);
}

} // namespace

PaletteDevices::PaletteDevices(const StructureView &structure, const Buses &buses,
                               const ProjectDocument &project, const Catalog &catalog,
                               std::function<void(Place)> choose)
    : m_structure(structure)
    , m_buses(buses)
    , m_project(project)
    , m_catalog(catalog)
    , m_choose(std::move(choose))
{}

void PaletteDevices::begin()
{
    m_isGiven = false;
}

std::vector<PaletteEntry> PaletteDevices::next()
{
    std::vector<PaletteEntry> entries;
    if (std::exchange(m_isGiven, true))
        return entries;
    for (const ListedDevice &device : m_structure.devices())
        entries.push_back(entryOf(device));
    return entries;
}

PaletteEntry PaletteDevices::entryOf(const ListedDevice &device) const
{
    return {.kind = PaletteEntry::Kind::device,
            .id = QStringLiteral("device:") + device.place.key(),
            .title = device.name,
            .context = joined({device.bus, device.state, device.position}, QStringLiteral(" \u00B7 ")),
            .words = wordsOf(device),
            .icon = device.icon,
            .run = [choose = m_choose, place = device.place] { choose(place); }};
}

// Type, ordering key and serial number, from its description and its label.
QString PaletteDevices::wordsOf(const ListedDevice &device) const
{
    QStringList words{device.code, device.profile, device.place.shown()};
    const ProjectDevice &planned = m_project.device(device.place);
    words << planned.label.serialNumber << planned.group << planned.note;
    const auto ofDescription = [&words](const DeviceDescription &its) {
        words << its.key << its.fullName() << (its.orderingKey ? its.orderingKey->example : QString());
    };
    if (const EncoderSession *session = m_buses.encoder(device.place))
        ofDescription(session->device());
    else if (const auto description = plannedDescription(planned, m_catalog))
        ofDescription(*description);
    return joined(words, QStringLiteral(" "));
}

} // namespace codewheel
