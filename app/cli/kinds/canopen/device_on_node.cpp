// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/device_on_node.h"

#include "catalog/catalog.h"
#include "catalog/label_key.h"
#include "cli/encoder/parameter_arguments.h"
#include "kinds/canopen/protocol/canopen_profile.h"

namespace codewheel {
namespace {

bool isForNodes(const DeviceDescription *device)
{
    return device != nullptr && device->profile == profile::cia406;
}

} // namespace

Checked<QString> deviceOnNode(const Call &call, Place place)
{
    const auto typed = call.arguments.value("--device");
    if (!typed) {
        const ProjectDevice *planned = call.project != nullptr ? findDevice(*call.project, place) : nullptr;
        const bool isUsable =
            planned != nullptr && isForNodes(call.catalog.find(planned->participant.deviceKey));
        return isUsable ? planned->participant.deviceKey : QString();
    }
    if (isForNodes(call.catalog.find(*typed)))
        return *typed;
    if (call.catalog.find(*typed) == nullptr)
        return tl::unexpected(deviceNamed(call.catalog, *typed).error());
    return tl::unexpected(
        complaintAbout({RefusalKind::badInput, RefusalId::deviceOfOtherBus, {place.shown(), *typed}}));
}

} // namespace codewheel
