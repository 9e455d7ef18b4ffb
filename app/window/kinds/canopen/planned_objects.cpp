// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/planned_objects.h"

#include "app/window/kinds/canopen/canopen_at_work.h"
#include "catalog/catalog.h"
#include "kinds/canopen/protocol/canopen_profile.h"
#include "transfer/transfer_wish.h"
#include "widgets/project/project_document.h"

namespace codewheel {
namespace {

// As it is connected, or else as it is planned.
const DeviceDescription *descriptionAt(const CanopenAtWork &bus, Place place, const ProjectDevice &planned)
{
    const EncoderSession *encoder = bus.session() != nullptr ? bus.session()->encoder(place) : nullptr;
    return encoder != nullptr ? &encoder->device() : bus.catalog().find(planned.participant.deviceKey);
}

} // namespace

DictionaryView::WantedByNode objectsWantedOn(const CanopenAtWork &bus)
{
    DictionaryView::WantedByNode wanted;
    bus.project().forEachDevice([&](Place place, const ProjectDevice &planned) {
        const DeviceDescription *device =
            place.bus == bus.id() ? descriptionAt(bus, place, planned) : nullptr;
        if (device == nullptr || device->profile != profile::cia406)
            return;
        auto objects = canopen::wantedObjects(*device, withoutItsPlace(planned.wanted), planned.wantedCams);
        if (!objects.empty())
            wanted.emplace(CanopenAddress::of(place.node).node, std::move(objects));
    });
    return wanted;
}

} // namespace codewheel
