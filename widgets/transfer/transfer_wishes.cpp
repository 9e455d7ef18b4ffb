// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_wishes.h"

#include "bus/buses.h"
#include "transfer/project_places.h"
#include "transfer/values_before.h"
#include "widgets/project/project_document.h"
#include "widgets/transfer/transfer_choice.h"

#include <algorithm>

namespace codewheel {
namespace {

// All that is planned or known of devices, those that the project does not have too, by number.
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

} // namespace

std::vector<TransferWish> transferWishes(const TransferChoice &choice, const Buses &buses,
                                         const Catalog &catalog, const ProjectDocument &project)
{
    std::vector<TransferWish> wishes;
    const ProjectPlaces places(project.project(), buses);
    using What = TransferChoice::What;
    const What what = choice.what();
    if (what == What::restore) {
        if (const ValuesBefore *before = choice.before())
            wishes.push_back(wishToRestore(*before, places));
        return wishes;
    }
    if (what == What::clone) {
        const auto from = choice.from();
        const EncoderSession *model = from ? buses.encoder(*from) : nullptr;
        for (const Place number : buses.places())
            if (const EncoderSession *to = buses.encoder(number);
                model && to && number != *from && to->can().writes)
                wishes.push_back(wishToClone(*model, *to, choice.withCams()));
        return wishes;
    }
    for (const ProjectDevice &device : plannedDevices(project)) {
        TransferWish wish = wishOf(
            device, what == What::write ? TransferSource::wanted : TransferSource::stored, places, catalog);
        if (!wish.values.empty() || !wish.cams.empty())
            wishes.push_back(std::move(wish));
    }
    return wishes;
}

} // namespace codewheel
