// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"

// The 32-bit process-data words of a TR LA-66 linear encoder.
//
//         D31          D30              D29    D28  D27..D24        D23..D0
//   OUT   service bit  0 read, 1 write  0      0    service number  data of a write
//   IN    the same     as OUT           error  0    as OUT          position, data written, data read
//
// The service bit asks (0 -> 1) and acknowledges; while it is 0, OUT has no effect and IN holds the position.
// Source: LA-66 manual 2.2, 2.3 and 3.
namespace codewheel::la66 {

inline constexpr int dataBits = 24;
inline constexpr Word dataMask = 0x00FF'FFFF;    // D23..D0
inline constexpr Word serviceMask = 0x0F00'0000; // D27..D24
inline constexpr Word serviceBit = 0x8000'0000;
inline constexpr Word writeBit = 0x4000'0000;
inline constexpr Word errorBit = 0x2000'0000;
inline constexpr Word reservedBit = 0x1000'0000;

inline constexpr Word normalMode = 0x0000'0000;

// Services (LA-66 manual 3). Those that can be both written and read are parameters of the encoder.
inline constexpr unsigned countingDirection = 1; // 0 increasing towards the end of the rod, 1 decreasing
inline constexpr unsigned measuringLength = 2;   // in steps, 1..FFFFFFh
inline constexpr unsigned externalPreset = 4;    // applied by the preset input
inline constexpr unsigned presetAdjustment = 6;  // write only: the position becomes the data
inline constexpr unsigned errorStatus = 8;       // read only

inline constexpr Word decreasing = 1;
inline constexpr Word magnetOutside = 1
                                      << 5; // bit of the error status (assumed: the table in ascending order)

constexpr unsigned service(Word word) noexcept
{
    return (word & serviceMask) >> dataBits;
}
constexpr Word data(Word word) noexcept
{
    return word & dataMask;
}

// The word that asks, with the service bit still 0: "data and service number must be output first".
constexpr Word writeWord(unsigned service, Word data) noexcept
{
    return writeBit | ((Word{service} << dataBits) & serviceMask) | (data & dataMask);
}
constexpr Word readWord(unsigned service) noexcept
{
    return (Word{service} << dataBits) & serviceMask;
}

constexpr bool isServiceMode(Word word) noexcept
{
    return (word & serviceBit) != 0;
}
constexpr bool isWrite(Word word) noexcept
{
    return (word & writeBit) != 0;
}
constexpr bool hasError(Word in) noexcept
{
    return (in & errorBit) != 0;
}

constexpr bool canBeRead(unsigned service) noexcept
{
    return service == countingDirection || service == measuringLength || service == externalPreset ||
           service == errorStatus;
}
constexpr bool canBeWritten(unsigned service) noexcept
{
    return service == countingDirection || service == measuringLength || service == externalPreset ||
           service == presetAdjustment;
}

// A word whose D30 and D28..D24 ask for an existing service, whatever the service bit. D29 of OUT does not
// belong to a service.
constexpr bool isService(Word word) noexcept
{
    if ((word & (errorBit | reservedBit)) != 0)
        return false;
    return isWrite(word) ? canBeWritten(service(word)) : canBeRead(service(word));
}

// Whether the service takes this value.
constexpr bool accepts(unsigned service, Word data) noexcept
{
    if (service == countingDirection)
        return data <= decreasing;
    if (service == measuringLength)
        return data != 0;
    return true;
}

// IN answers OUT: the same service and direction, in service mode.
constexpr bool answers(Word in, Word out) noexcept
{
    constexpr Word request = serviceBit | writeBit | reservedBit | serviceMask;
    return isServiceMode(in) && (in & request) == ((out | serviceBit) & request);
}

} // namespace codewheel::la66
