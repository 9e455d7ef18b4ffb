// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/device_number.h"
#include "tests/support/places.h"

namespace codewheel {

// "1.0"_ring
constexpr Place operator""_ring(const char *text, std::size_t size)
{
    return {firstBus, NodeId({text, size})};
}

// The same position in the next segment.
inline NodeId nextSegment(NodeId node)
{
    DeviceNumber number = DeviceNumber::of(node);
    ++number.segment;
    return number.node();
}

} // namespace codewheel
