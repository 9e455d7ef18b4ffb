// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/interbus/words/device_number.h"

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

} // namespace codewheel
