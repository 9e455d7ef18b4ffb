// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/sdo.h"

// The objects that the driver itself asks for (CiA 301; CiA 406), whatever the description names.
namespace codewheel::canopen::object {

inline constexpr SdoObject deviceType{0x1000, 0};
inline constexpr SdoObject store{0x1010, 1};
inline constexpr SdoObject restore{0x1011, 1};
inline constexpr SdoObject vendor{0x1018, 1};
inline constexpr SdoObject product{0x1018, 2};
inline constexpr SdoObject operatingParameters{0x6000, 0};
inline constexpr SdoObject preset{0x6003, 0};
inline constexpr SdoObject position{0x6004, 0};
inline constexpr SdoObject speed{0x6030, 1};
inline constexpr SdoObject alarms{0x6503, 0};
inline constexpr SdoObject warnings{0x6505, 0};
inline constexpr SdoObject versions{0x6507, 0};
inline constexpr SdoObject operatingTime{0x6508, 0};

inline constexpr std::uint32_t saveSignature = 0x6576'6173; // "save"
inline constexpr std::uint32_t loadSignature = 0x6461'6F6C; // "load"

} // namespace codewheel::canopen::object
