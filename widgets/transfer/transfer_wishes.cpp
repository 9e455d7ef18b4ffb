// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_wishes.h"

#include "ring/bus_session.h"
#include "transfer/project_places.h"
#include "transfer/values_before.h"
#include "widgets/project/project_document.h"
#include "widgets/transfer/transfer_choice.h"

#include <algorithm>

namespace codewheel {

std::vector<ProjectDevice> plannedDevices(const ProjectDocument &project)
{
    std::vector<ProjectDevice> devices;
    project.forEachDevice([&](Place number, const ProjectDevice &device) {
        devices.push_back(device);
        devices.back().standAt(number);
    });
    std::ranges::sort(devices, {}, [](const ProjectDevice &device) { return device.place(); });
    return devices;
}

std::vector<TransferWish> transferWishes(const TransferChoice &choice, const BusSession &bus,
                                         const ProjectDocument &project)
{
    std::vector<TransferWish> wishes;
    const ProjectPlaces places(project.project(), bus);
    using What = TransferChoice::What;
    const What what = choice.what();
    if (what == What::restore) {
        if (const ValuesBefore *before = choice.before())
            wishes.push_back(wishToRestore(*before, places));
        return wishes;
    }
    if (what == What::clone) {
        const auto from = choice.from();
        const EncoderSession *model = from ? bus.encoder(*from) : nullptr;
        for (const Place number : bus.places())
            if (const EncoderSession *to = bus.encoder(number);
                model && to && number != *from && to->can().writes)
                wishes.push_back(wishToClone(*model, *to, choice.withCams()));
        return wishes;
    }
    for (const ProjectDevice &device : plannedDevices(project)) {
        TransferWish wish =
            wishOf(device, what == What::write ? TransferSource::wanted : TransferSource::stored, places);
        if (!wish.values.empty() || !wish.cams.empty())
            wishes.push_back(std::move(wish));
    }
    return wishes;
}

} // namespace codewheel
