// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace codewheel {

// A classic CAN frame.
struct CanFrame
{
    static constexpr std::uint8_t mostBytes = 8;

    std::uint32_t id = 0; // 11 or 29 bits; of an error frame its class as in SocketCAN, 0: not known
    bool isExtended = false;
    bool isRemote = false;
    bool isError = false;
    std::uint8_t length = 0; // of its data; of a remote frame, of the data that it asks for
    std::array<std::uint8_t, mostBytes> bytes{};
    std::string interface {};      // "can0"; empty: not known
    std::optional<Instant> time{}; // since 1970, or since a beginning that whoever made it knows

    std::span<const std::uint8_t> data() const { return std::span(bytes).first(isRemote ? 0 : length); }

    friend bool operator==(const CanFrame &, const CanFrame &) = default;
};

inline constexpr std::uint32_t largestStandardId = 0x7FF;
inline constexpr std::uint32_t largestExtendedId = 0x1FFF'FFFF;
// Marks error frames in logs, as in SocketCAN.
inline constexpr std::uint32_t errorFrameFlag = 0x2000'0000;

} // namespace codewheel
