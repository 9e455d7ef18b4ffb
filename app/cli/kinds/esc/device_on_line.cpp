// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/device_on_line.h"

#include "catalog/catalog.h"
#include "catalog/label_key.h"
#include "cli/call/texts.h"
#include "cli/encoder/parameter_arguments.h"
#include "kinds/esc/protocol/esc_profile.h"
#include "kinds/esc/protocol/esc_refusals.h"

#include <algorithm>

namespace codewheel {
namespace {

const QString usualDevice = QStringLiteral("kuebler-esc-rs485");

bool isForLines(const DeviceDescription *device)
{
    return device != nullptr && device->profile == profile::esc;
}

} // namespace

QString usualDeviceOnLine()
{
    return usualDevice;
}

QString deviceOf(const Call &call, const ProjectDevice *planned)
{
    const bool isUsable = planned != nullptr && isForLines(call.catalog.find(planned->participant.deviceKey));
    return isUsable ? planned->participant.deviceKey : usualDevice;
}

Checked<void> checkIsAlone(const Call &call, Place place)
{
    const EscLineAddress address = EscLineAddress::of(place.node);
    if (!address.isMaster() || call.project == nullptr || devicesOn(*call.project, place.bus).size() < 2)
        return {};
    const QString others = listed(devicesOn(*call.project, place.bus),
                                  [](const ProjectDevice &encoder) { return encoder.place().shown(); });
    return tl::unexpected(complaintAbout(
        {RefusalKind::badInput, EscRefusalId::lineAddressNotAlone, {address.shown(), others}}));
}

Checked<QString> deviceOnLine(const Call &call, Place place)
{
    const auto typed = call.arguments.value("--device");
    if (!typed)
        return deviceOf(call, call.project != nullptr ? findDevice(*call.project, place) : nullptr);
    if (isForLines(call.catalog.find(*typed)))
        return *typed;
    if (const auto matches = findByLabel(call.catalog, *typed)) {
        const auto match =
            std::ranges::find_if(*matches, [](const LabelMatch &one) { return isForLines(one.device); });
        if (match != matches->end())
            return match->device->key;
    } else if (call.catalog.find(*typed) == nullptr) {
        return tl::unexpected(deviceNamed(call.catalog, *typed).error());
    }
    return tl::unexpected(
        complaintAbout({RefusalKind::badInput, RefusalId::deviceOfOtherBus, {place.shown(), *typed}}));
}

} // namespace codewheel
