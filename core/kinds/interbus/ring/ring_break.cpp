// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_break.h"

#include "kinds/interbus/ring/ring_tree.h"

#include <algorithm>

namespace codewheel {
namespace {

std::optional<std::size_t> outgoingRemote(const RingTree &tree, std::size_t device)
{
    const std::vector<std::size_t> &line = tree.busOf(device);
    const std::size_t next = tree.rowOf(device) + 1;
    return next < line.size() ? std::optional(line[next]) : std::nullopt;
}

std::optional<std::size_t> outgoingLocal(const RingTree::Node &terminal, const std::vector<bool> &cutOff)
{
    std::optional<std::size_t> first;
    for (const auto *line : {&terminal.localBus, &terminal.branch})
        if (!line->empty() && (!first || (!cutOff[*first] && cutOff[line->front()])))
            first = line->front();
    return first;
}

NodeId nodeBefore(const RingStructure &ring, const RingTree &tree, std::size_t device)
{
    if (const std::size_t row = tree.rowOf(device); row > 0)
        return ring[tree.busOf(device)[row - 1]].number;
    const auto parent = tree.nodes[device].parent;
    return parent ? ring[*parent].number : NodeId();
}

} // namespace

RingBreak breakAt(const RingStructure &ring, const FaultPlace &place, const std::vector<bool> &cutOff)
{
    const auto at = std::ranges::find(ring, place.number, &RingDevice::number);
    if (at == ring.end())
        return {};
    const RingTree tree = ringTree(ring);
    const auto device = static_cast<std::size_t>(at - ring.begin());
    if (place.spot == FaultSpot::device)
        return {nodeBefore(ring, tree, device), place.number};
    const auto behind = place.spot == FaultSpot::outgoingRemoteBus
                            ? outgoingRemote(tree, device)
                            : outgoingLocal(tree.nodes[device], cutOff);
    return {place.number, behind ? ring[*behind].number : NodeId()};
}

} // namespace codewheel
