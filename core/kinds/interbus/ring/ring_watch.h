// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"
#include "vocabulary/reading.h"

#include <vector>

namespace codewheel {

// Turns what a device shows in every cycle into a message when a fault appears, changes or goes away. Used by
// the runner, so that even a fault that lasts one cycle is reported.
class FaultWatch
{
public:
    explicit FaultWatch(std::size_t devices)
        : m_faults(devices)
    {}

    // Empty while nothing changes. No time and place.
    std::optional<Message> look(std::size_t device, const Reading &reading);

private:
    std::vector<std::optional<unsigned>> m_faults; // error numbers
};

} // namespace codewheel
