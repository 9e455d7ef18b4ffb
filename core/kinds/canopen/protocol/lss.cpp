// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/lss.h"

namespace codewheel::canopen {

std::optional<LssFrame> LssFrame::read(Octets data)
{
    constexpr std::size_t size = 8;
    constexpr std::size_t bitAt = 5;
    constexpr std::size_t wordAt = 6;
    if (data.size() != size)
        return std::nullopt;
    return LssFrame{.command = static_cast<LssCommand>(data[0]),
                    .number = numberOf(data.subspan(1, 4)),
                    .bit = data[bitAt],
                    .word = data[wordAt]};
}

} // namespace codewheel::canopen
