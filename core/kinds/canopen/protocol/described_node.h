// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/canopen/protocol/node_identity.h"

#include <array>
#include <optional>
#include <span>

namespace codewheel::canopen {

// What a node has told of 1018h:1 to 4.
using ToldIdentity = std::array<std::optional<std::uint32_t>, NodeIdentity::size>;

// The description that a node is recognised by: its vendor and product, and its revision, or one that differs
// from it in its low word only (CiA 301: the same behaviour). Null: there is none.
const DeviceDescription *describedNode(std::span<const DeviceDescription> devices, const ToldIdentity &node);
// Whether there is any to recognise a node by.
bool describesNodes(std::span<const DeviceDescription> devices);

} // namespace codewheel::canopen
