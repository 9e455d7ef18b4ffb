// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace codewheel {

// The topology of a ring: the main line, and below each bus terminal its local bus and its branch. Devices
// are given by their indices in ring order. Any structure has a tree: a device whose terminal is missing is
// put below the device before it, or on the main line.
struct RingTree
{
    struct Node
    {
        std::optional<std::size_t> parent; // empty: on the main line
        bool isLocal = false;              // on the local bus of its parent; otherwise in its branch
        std::vector<std::size_t> localBus;
        std::vector<std::size_t> branch;

        bool isLeaf() const { return localBus.empty() && branch.empty(); }
    };

    std::vector<Node> nodes; // in the order of the structure
    std::vector<std::size_t> mainLine;

    // The bus a device is on, and its row there.
    const std::vector<std::size_t> &busOf(std::size_t device) const;
    std::vector<std::size_t> &busOf(std::size_t device);
    std::size_t rowOf(std::size_t device) const;
    bool hangsBelow(std::size_t device, std::size_t terminal) const; // or is the terminal itself
    // All devices in ring order: a device, its local bus, its branch, then the next of its level.
    std::vector<std::size_t> order() const;
};

RingTree ringTree(const RingStructure &structure);

// The participants in the ring order of the tree, with the numbers and levels that follow from it: segments
// are counted along the ring, so a branch is counted before the level goes on; the devices of a local bus are
// n.1, n.2, ...
RingStructure numbered(const RingTree &tree, const RingStructure &participants);

} // namespace codewheel
