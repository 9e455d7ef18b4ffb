// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"
#include "vocabulary/refusal.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace codewheel {

// Error codes of the master with a known text; for any other only the number is shown.
namespace bus_error {
inline constexpr std::uint16_t peripheralFault = 0x0BB1;
inline constexpr std::uint16_t lookingForFault = 0x0BDF;
inline constexpr std::uint16_t nothingFound = 0x0BE1; // failed, and the check finds nothing: intermittent
} // namespace bus_error

// The diagnostic parameter register: where the fault is. High byte: segment; low byte: position, or 80h and
// 81h for an outgoing interface of the segment's remote-bus device. Segment 0 with 80h: not located.
inline constexpr std::uint16_t notLocated = 0x0080;
enum class FaultSpot : std::uint8_t { device, outgoingRemoteBus, outgoingLocalBus };
struct FaultPlace
{
    NodeId number;
    FaultSpot spot = FaultSpot::device;

    friend bool operator==(const FaultPlace &, const FaultPlace &) = default;
};

// Empty for 0 and for 0080h.
std::optional<FaultPlace> faultPlaceOf(std::uint16_t diagnosticParameter);
// 0300h for 3.0, 0280h for the outgoing remote bus of 2.0.
std::uint16_t diagnosticParameterOf(const FaultPlace &place);

// "3.0", "outgoing remote bus of 2.0", in the user's language.
QString faultPlaceText(const FaultPlace &place);
// The name of a fault, the same wherever it is shown: "0BB1 – peripheral fault at 3.0". A code without a
// known text is given as its number and where to look it up.
QString busFaultText(std::uint16_t errorCode, std::uint16_t diagnosticParameter);
// The same for a message or refusal that has both as its arguments.
std::uint16_t diagnosticParameterOf(const std::vector<RefusalArgument> &codeAndParameter);
QString busFaultText(const std::vector<RefusalArgument> &codeAndParameter);

} // namespace codewheel
