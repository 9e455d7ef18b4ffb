// SPDX-License-Identifier: GPL-3.0-or-later
// What the library of protocols has of every kind: another kind has a row in each list.
#include "catalog/protocol_rules.h"
#include "jobs/protocol.h"
#include "kinds/esc/driver/esc_protocol.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/protocol/esc_rules.h"
#include "kinds/interbus/k3/k3_protocol.h"
#include "kinds/interbus/k3/k3_rules.h"
#include "kinds/interbus/la66/la66_protocol.h"
#include "kinds/interbus/la66/la66_rules.h"
#include "kinds/interbus/words/device_number.h"
#include "vocabulary/place.h"

#include <array>

namespace codewheel {

// For a kind of bus without a row here, a place is read only with the number of its bus.
std::span<const PlaceFormat> placeFormats()
{
    const auto ofRing = [](QStringView text) -> std::optional<NodeId> {
        const auto number = DeviceNumber::parse(text);
        return number ? std::optional(number->node()) : std::nullopt;
    };
    const auto ofLine = [](QStringView text) -> std::optional<NodeId> {
        const auto address = addressTyped(text);
        return address ? std::optional(address->node()) : std::nullopt;
    };
    static const std::array formats{PlaceFormat{firstRing, ofRing}, PlaceFormat{firstLine, ofLine}};
    return formats;
}

const ProtocolRules &protocolRules(Profile profile)
{
    static const ProtocolRules withoutParameters;
    switch (profile) {
    case Profile::k3:
        return k3Rules();
    case Profile::la66:
        return la66Rules();
    case Profile::esc:
        return escRules();
    case Profile::k1:
    case Profile::k2:
    case Profile::k4:
        break;
    }
    return withoutParameters;
}

const Protocol &protocolOf(const DeviceDescription &device)
{
    switch (device.profile) {
    case Profile::la66:
        return la66Protocol();
    case Profile::esc:
        return escProtocol();
    case Profile::k1:
    case Profile::k2:
    case Profile::k3:
    case Profile::k4:
        break;
    }
    return k3Protocol();
}

} // namespace codewheel
