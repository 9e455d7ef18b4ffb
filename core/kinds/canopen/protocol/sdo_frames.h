// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/sdo.h"

namespace codewheel::canopen {

// What the client sends (CiA 301, 7.2.4.3). SdoFrame reads it.
using SdoOctets = std::array<std::uint8_t, 8>;

inline constexpr std::size_t mostInFrame = 4; // of a value that needs no segments

// Codes of aborts that the client gives.
inline constexpr std::uint32_t abortToggle = 0x0503'0000;
inline constexpr std::uint32_t abortTimeOut = 0x0504'0000;
inline constexpr std::uint32_t abortMemory = 0x0504'0005;
inline constexpr std::uint32_t abortTooLong = 0x0607'0012;
inline constexpr std::uint32_t abortTooShort = 0x0607'0013;

SdoOctets sdoRead(const SdoObject &object);
SdoOctets sdoWrite(const SdoObject &object, Octets value); // of one to four bytes
SdoOctets sdoWriteBegins(const SdoObject &object, std::size_t size);
SdoOctets sdoNextSegment(bool toggle);
SdoOctets sdoSegment(Octets data, bool toggle, bool isLast); // of at most seven bytes
SdoOctets sdoAbort(const SdoObject &object, std::uint32_t code);

} // namespace codewheel::canopen
