// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/palette_entries.h"
#include "bus/buses.h"
#include "catalog/catalog.h"
#include "project/project.h"
#include "widgets/project/project_document.h"
#include "widgets/structure/structure_view.h"

namespace codewheel {
namespace {

QString joined(QStringList parts, const QString &between)
{
    parts.removeAll(QString());
    return parts.join(between);
}

// Type, ordering key and serial number, from its description and its label.
QString wordsOf(const ListedDevice &device, const Buses &buses, const ProjectDevice &planned,
                const Catalog &catalog)
{
    QStringList words{device.code, device.profile, device.place.shown()};
    words << planned.label.serialNumber << planned.group << planned.note;
    const auto ofDescription = [&words](const DeviceDescription &its) {
        words << its.key << its.fullName() << (its.orderingKey ? its.orderingKey->example : QString());
    };
    if (const EncoderSession *session = buses.encoder(device.place))
        ofDescription(session->device());
    else if (const auto description = plannedDescription(planned, catalog))
        ofDescription(*description);
    return joined(words, QStringLiteral(" "));
}

} // namespace

std::vector<PaletteEntry> deviceEntries(const StructureView &structure, const Buses &buses,
                                        const ProjectDocument &project, const Catalog &catalog,
                                        const std::function<void(Place)> &choose)
{
    std::vector<PaletteEntry> entries;
    for (const ListedDevice &device : structure.devices())
        entries.push_back(
            {.kind = PaletteEntry::Kind::device,
             .id = QStringLiteral("device:") + device.place.key(),
             .title = device.name,
             .context = joined({device.bus, device.state, device.position}, QStringLiteral(" \u00B7 ")),
             .words = wordsOf(device, buses, project.device(device.place), catalog),
             .icon = device.icon,
             .run = [choose, place = device.place] { choose(place); }});
    return entries;
}

} // namespace codewheel
