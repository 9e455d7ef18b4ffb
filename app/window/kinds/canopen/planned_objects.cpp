// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/planned_objects.h"

#include "app/window/kinds/canopen/canopen_at_work.h"
#include "catalog/catalog.h"
#include "kinds/canopen/protocol/canopen_profile.h"
#include "transfer/transfer_wish.h"
#include "widgets/project/project_document.h"

#include <QDir>
#include <QFileInfo>

namespace codewheel {
namespace {

// As it is connected, or else as it is planned.
const DeviceDescription *descriptionAt(const CanopenAtWork &bus, Place place, const ProjectDevice &planned)
{
    const EncoderSession *encoder = bus.session() != nullptr ? bus.session()->encoder(place) : nullptr;
    return encoder != nullptr ? &encoder->device() : bus.catalog().find(planned.participant.deviceKey);
}

std::vector<canopen::WantedObject> wantedOf(const CanopenAtWork &bus, Place place,
                                            const ProjectDevice &planned)
{
    const DeviceDescription *device = descriptionAt(bus, place, planned);
    if (device == nullptr || device->profile != profile::cia406)
        return {};
    return canopen::wantedObjects(*device, wantedSettings(planned, device), planned.wantedCams);
}

QString fileOf(const ProjectDevice &planned, const QString &project)
{
    const QString file = planned.its<CanopenEncoderSettings>().file;
    if (file.isEmpty() || project.isEmpty() || QFileInfo::exists(file))
        return file;
    const QString beside = QFileInfo(project).dir().filePath(QFileInfo(file).fileName());
    return QFileInfo::exists(beside) ? beside : file;
}

} // namespace

PlannedObjects plannedObjectsOn(const CanopenAtWork &bus)
{
    const ProjectDocument &document = bus.project();
    PlannedObjects planned;
    document.forEachDevice([&](Place place, const ProjectDevice &device) {
        if (place.bus != bus.id())
            return;
        const int node = CanopenAddress::of(place.node).node;
        auto wanted = wantedOf(bus, place, device);
        if (!wanted.empty())
            planned.wanted.emplace(node, std::move(wanted));
        if (findDevice(document.project(), place) != nullptr)
            planned.files.emplace(node, fileOf(device, document.file()));
    });
    return planned;
}

} // namespace codewheel
