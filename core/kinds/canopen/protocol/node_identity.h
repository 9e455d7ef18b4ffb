// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace codewheel::canopen {

// Object 1018h:1 to 4, which LSS goes by, too: vendor, product, revision, serial number.
struct NodeIdentity
{
    static constexpr std::size_t size = 4;

    std::array<std::uint32_t, size> words{};

    std::uint32_t vendor() const { return words[0]; }
    std::uint32_t product() const { return words[1]; }
    std::uint32_t revision() const { return words[2]; }
    std::uint32_t serial() const { return words[3]; }

    friend bool operator==(const NodeIdentity &, const NodeIdentity &) = default;
};

} // namespace codewheel::canopen
