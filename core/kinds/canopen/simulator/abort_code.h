// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel::canopen {

// CiA 301, table 22, as far as a simulated node uses it.
enum class AbortCode : std::uint32_t {
    toggle = 0x0503'0000,
    command = 0x0504'0001,
    access = 0x0601'0000,
    writeOnly = 0x0601'0001,
    readOnly = 0x0601'0002,
    noObject = 0x0602'0000,
    notMappable = 0x0604'0041,
    pdoTooLong = 0x0604'0042,
    hardware = 0x0606'0000,
    wrongLength = 0x0607'0010,
    tooLong = 0x0607'0012,
    tooShort = 0x0607'0013,
    noSubindex = 0x0609'0011,
    range = 0x0609'0030,
    tooHigh = 0x0609'0031,
    tooLow = 0x0609'0032,
    lowAboveHigh = 0x0609'0036,
    cannotStore = 0x0800'0020,
    localControl = 0x0800'0021,
    deviceState = 0x0800'0022,
    noData = 0x0800'0024,
};

} // namespace codewheel::canopen
