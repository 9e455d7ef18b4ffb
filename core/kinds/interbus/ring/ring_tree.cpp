// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_tree.h"

#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/words/device_number.h"

#include <algorithm>

namespace codewheel {
namespace {

// The last remote-bus device before `place` for which it holds.
template <typename Holds>
std::optional<std::size_t> remoteBefore(const RingStructure &structure, std::size_t place, Holds holds)
{
    for (std::size_t i = place; i-- > 0;)
        if (!isOnLocalBus(structure[i]) && holds(structure[i]))
            return i;
    return std::nullopt;
}

std::optional<std::size_t> terminalOf(const RingStructure &structure, std::size_t place)
{
    const RingDevice &device = structure[place];
    if (!isOnLocalBus(device))
        return remoteBefore(structure, place,
                            [&](const RingDevice &other) { return other.level < device.level; });
    const auto ofSegment = remoteBefore(structure, place, [&](const RingDevice &other) {
        return DeviceNumber::of(other.number).segment == DeviceNumber::of(device.number).segment;
    });
    return ofSegment ? ofSegment : remoteBefore(structure, place, [](const RingDevice &) { return true; });
}

void append(const RingTree &tree, const std::vector<std::size_t> &bus, std::vector<std::size_t> &order)
{
    for (const std::size_t device : bus) {
        order.push_back(device);
        append(tree, tree.nodes[device].localBus, order);
        append(tree, tree.nodes[device].branch, order);
    }
}

} // namespace

const std::vector<std::size_t> &RingTree::busOf(std::size_t device) const
{
    const Node &node = nodes[device];
    if (!node.parent)
        return mainLine;
    return node.isLocal ? nodes[*node.parent].localBus : nodes[*node.parent].branch;
}

std::vector<std::size_t> &RingTree::busOf(std::size_t device)
{
    return const_cast<std::vector<std::size_t> &>(std::as_const(*this).busOf(device));
}

std::size_t RingTree::rowOf(std::size_t device) const
{
    const std::vector<std::size_t> &bus = busOf(device);
    return static_cast<std::size_t>(std::ranges::find(bus, device) - bus.begin());
}

bool RingTree::hangsBelow(std::size_t device, std::size_t terminal) const
{
    for (std::optional<std::size_t> at = device; at; at = nodes[*at].parent)
        if (*at == terminal)
            return true;
    return false;
}

std::vector<std::size_t> RingTree::order() const
{
    std::vector<std::size_t> order;
    order.reserve(nodes.size());
    append(*this, mainLine, order);
    return order;
}

RingTree ringTree(const RingStructure &structure)
{
    RingTree tree;
    tree.nodes.resize(structure.size());
    std::optional<std::size_t> lastRemote; // shortcut for the usual case: on the same level
    for (std::size_t place = 0; place < structure.size(); ++place) {
        RingTree::Node &node = tree.nodes[place];
        node.isLocal = isOnLocalBus(structure[place]);
        if (!node.isLocal && lastRemote && structure[*lastRemote].level == structure[place].level)
            node.parent = tree.nodes[*lastRemote].parent;
        else if (node.isLocal || structure[place].level > 0)
            node.parent = terminalOf(structure, place);
        if (!node.isLocal)
            lastRemote = place;
        tree.busOf(place).push_back(place);
    }
    return tree;
}

RingStructure numbered(const RingTree &tree, const RingStructure &participants)
{
    const std::vector<std::size_t> order = tree.order();
    RingStructure structure;
    structure.reserve(order.size());
    std::vector<std::size_t> placeOf(participants.size());
    std::vector<int> positions(order.size(), 0);
    int segment = 0;
    for (const std::size_t device : order) {
        const RingTree::Node &node = tree.nodes[device];
        RingDevice participant = participants[device];
        const RingDevice *parent = node.parent ? &structure[placeOf[*node.parent]] : nullptr;
        if (node.isLocal)
            participant.number =
                DeviceNumber{parent ? DeviceNumber::of(parent->number).segment : std::max(segment, 1),
                             ++positions[parent ? placeOf[*node.parent] : 0]}
                    .node();
        else
            participant.number = DeviceNumber{++segment, 0}.node();
        participant.level = parent ? parent->level + (node.isLocal ? 0 : 1) : 0;
        placeOf[device] = structure.size();
        structure.push_back(std::move(participant));
    }
    return structure;
}

} // namespace codewheel
