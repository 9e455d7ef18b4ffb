// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace codewheel {

// The description of an encoder of no special make, by its key in the catalog.

// What a node is taken for where nobody knows better: multi-turn.
QString usualDeviceOnNode();
// By its device type (1000h): the form of encoder that CiA 406 has there. Empty: it is none of these.
QString deviceOfType(std::uint32_t deviceType);

} // namespace codewheel
