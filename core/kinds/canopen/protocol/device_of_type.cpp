// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/device_of_type.h"

#include "catalog/catalog.h"
#include "kinds/canopen/protocol/device_profile.h"

namespace codewheel {
namespace {

const QString singleTurnOnNode = QStringLiteral("canopen-406-single-turn");
const QString multiTurnOnNode = QStringLiteral("canopen-406-multi-turn");
const QString linearOnNode = QStringLiteral("canopen-406-linear");

} // namespace

QString usualDeviceOnNode()
{
    return multiTurnOnNode;
}

// The forms from 6 to 9 are linear, 1 is single-turn.
QString deviceOfType(std::uint32_t deviceType)
{
    constexpr unsigned formShift = 16;
    if (canopen::profileOf(deviceType) != canopen::encoderProfile)
        return {};
    const std::uint32_t form = deviceType >> formShift;
    if (form == 1)
        return singleTurnOnNode;
    return form >= 6 && form <= 9 ? linearOnNode : multiTurnOnNode;
}

QString deviceOfNode(const Catalog &catalog, std::optional<std::uint32_t> deviceType,
                     const canopen::ToldIdentity &identity)
{
    const DeviceDescription *described = canopen::describedNode(catalog.devices(), identity);
    if (described != nullptr)
        return described->key;
    return deviceType ? deviceOfType(*deviceType) : QString();
}

} // namespace codewheel
