// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <optional>

namespace codewheel::canopen {

inline constexpr std::uint16_t encoderProfile = 406;

// The profile by which a device goes: the low word of its device type (1000h).
constexpr std::uint16_t profileOf(std::uint32_t deviceType)
{
    return static_cast<std::uint16_t>(deviceType);
}

// Whether a device tells that it goes by the profile of something else, where 6000h.. mean something else.
// Who tells no profile (0) or nothing may be an encoder all the same.
constexpr bool isOfOtherProfile(std::optional<std::uint32_t> deviceType)
{
    return deviceType && profileOf(*deviceType) != 0 && profileOf(*deviceType) != encoderProfile;
}

// "410 (inclinometers)", or only the number.
QString profileText(std::int64_t profile);

} // namespace codewheel::canopen
