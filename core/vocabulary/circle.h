// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

// Positions on a circle: after the last of `total` comes the first again.
namespace codewheel {

constexpr std::int64_t modulo(std::int64_t value, std::int64_t total) noexcept
{
    const std::int64_t rest = value % total;
    return rest < 0 ? rest + total : rest;
}

// From one position to another, possibly across the end of the range; negative going down.
constexpr std::int64_t shorterWay(std::int64_t from, std::int64_t to, std::int64_t total) noexcept
{
    const std::int64_t way = to - from;
    if (way > total / 2)
        return way - total;
    return way < -(total / 2) ? way + total : way;
}

// Where positions are signed, the upper half of the range is below 0.
constexpr std::int64_t signedPosition(std::int64_t position, std::int64_t total) noexcept
{
    return position >= (total + 1) / 2 ? position - total : position;
}

} // namespace codewheel
