// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/message.h"
#include "encoder/reading.h"

#include <vector>

namespace codewheel {

// Turns what a device shows in every cycle into a message when a fault appears, changes or goes. Used by the
// runner, so that a fault of a single cycle is told.
class FaultWatch
{
public:
    explicit FaultWatch(std::size_t devices)
        : m_faults(devices)
    {}

    // Nothing while nothing changes. No time and place.
    std::optional<Message> look(std::size_t device, const Reading &reading);

private:
    std::vector<std::optional<unsigned>> m_faults; // error numbers
};

} // namespace codewheel
