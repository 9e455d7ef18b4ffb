// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "kinds/canopen/protocol/octets.h"

#include <algorithm>

namespace codewheel::canopen {

// With at most eight bytes.
inline CanFrame frameOf(std::uint32_t identifier, Octets data)
{
    CanFrame frame{.id = identifier, .length = static_cast<std::uint8_t>(data.size())};
    std::ranges::copy(data, frame.bytes.begin());
    return frame;
}

// Whether it carries data under this identifier of 11 bits.
inline bool isDataOf(const CanFrame &frame, std::uint32_t identifier)
{
    return frame.id == identifier && !frame.isExtended && !frame.isRemote && !frame.isError;
}

// With object 1019h the SYNCs are counted. Object 1005h may name another identifier.
inline CanFrame syncFrame(std::optional<std::uint8_t> counter = {}, std::uint32_t identifier = 0x080)
{
    return counter ? frameOf(identifier, Octets(&*counter, 1)) : frameOf(identifier, {});
}

} // namespace codewheel::canopen
