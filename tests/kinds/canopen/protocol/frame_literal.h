// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace codewheel::canopen {

using ByteList = std::vector<std::uint8_t>;

// "605#40046000": the identifier and up to eight bytes, padded with 0 where they are followed by "..".
// "705#R" is a remote frame. Blanks do not count.
inline CanFrame frameFrom(std::string_view text)
{
    std::string digits;
    for (const char each : text)
        if (each != ' ')
            digits += each;
    const std::size_t hash = digits.find('#');
    CanFrame frame{.id = static_cast<std::uint32_t>(std::stoul(digits.substr(0, hash), nullptr, 16))};
    digits.erase(0, hash + 1);
    frame.isRemote = digits == "R";
    while (digits.size() >= 2 && !digits.starts_with("..")) {
        frame.bytes.at(frame.length++) =
            static_cast<std::uint8_t>(std::stoul(digits.substr(0, 2), nullptr, 16));
        digits.erase(0, 2);
    }
    if (digits == "..")
        frame.length = CanFrame::mostBytes;
    return frame;
}

// For failures: "605#4004600000000000".
inline std::string textOf(const CanFrame &frame)
{
    char text[16];
    std::snprintf(text, sizeof text, "%03X#", frame.id);
    std::string all = text;
    for (const std::uint8_t each : frame.data()) {
        std::snprintf(text, sizeof text, "%02X", each);
        all += text;
    }
    return frame.isRemote ? all + "R" : all;
}

} // namespace codewheel::canopen
