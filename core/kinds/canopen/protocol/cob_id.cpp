// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/cob_id.h"

#include <array>

namespace codewheel::canopen {
namespace {

using Service = CobId::Service;

constexpr unsigned nodeBitCount = 7;
constexpr std::uint32_t nodeBits = (1U << nodeBitCount) - 1;

struct WithoutNode
{
    std::uint32_t identifier;
    Service service;
};

constexpr std::array withoutNode{
    WithoutNode{0x000, Service::nmt},        WithoutNode{0x080, Service::sync},
    WithoutNode{0x100, Service::time},       WithoutNode{0x7E4, Service::lssAnswer},
    WithoutNode{0x7E5, Service::lssRequest},
};

struct OfNodes
{
    std::uint32_t base; // the node is added
    Service service;
    int number = 0;
};

constexpr std::array ofNodes{
    OfNodes{0x080, Service::emcy},       OfNodes{0x180, Service::tpdo, 1},
    OfNodes{0x200, Service::rpdo, 1},    OfNodes{0x280, Service::tpdo, 2},
    OfNodes{0x300, Service::rpdo, 2},    OfNodes{0x380, Service::tpdo, 3},
    OfNodes{0x400, Service::rpdo, 3},    OfNodes{0x480, Service::tpdo, 4},
    OfNodes{0x500, Service::rpdo, 4},    OfNodes{0x580, Service::sdoAnswer},
    OfNodes{0x600, Service::sdoRequest}, OfNodes{0x700, Service::errorControl},
};

// The same by the bits above the node; null: none. Asked for each frame, several times.
constexpr auto rowsOfNodes = [] {
    std::array<const OfNodes *, 16> rows{};
    for (const OfNodes &each : ofNodes)
        rows.at(each.base >> nodeBitCount) = &each;
    return rows;
}();

} // namespace

std::optional<CobId> CobId::of(std::uint32_t identifier)
{
    for (const WithoutNode &each : withoutNode)
        if (each.identifier == identifier)
            return CobId{.service = each.service};
    const auto node = static_cast<int>(identifier & nodeBits);
    const std::uint32_t row = identifier >> nodeBitCount;
    if (node == 0 || row >= rowsOfNodes.size() || rowsOfNodes[row] == nullptr)
        return std::nullopt;
    return CobId{.service = rowsOfNodes[row]->service, .node = node, .number = rowsOfNodes[row]->number};
}

std::uint32_t CobId::identifier() const
{
    for (const WithoutNode &each : withoutNode)
        if (each.service == service)
            return each.identifier;
    for (const OfNodes &each : ofNodes)
        if (each.service == service && each.number == number)
            return each.base + static_cast<std::uint32_t>(node);
    return 0;
}

} // namespace codewheel::canopen
