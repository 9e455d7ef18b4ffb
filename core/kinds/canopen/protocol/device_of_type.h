// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/described_node.h"

#include <QString>

namespace codewheel {

class Catalog;

// The description of an encoder of no special make, by its key in the catalog.

// What a node is taken for where nobody knows better: multi-turn.
QString usualDeviceOnNode();
// By its device type (1000h): the form of encoder that CiA 406 has there. Empty: it is none of these.
QString deviceOfType(std::uint32_t deviceType);

// As its identity (1018h) is described, or else by its device type. Empty: it is none of these.
QString deviceOfNode(const Catalog &catalog, std::optional<std::uint32_t> deviceType,
                     const canopen::ToldIdentity &identity);

} // namespace codewheel
