// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/comparison.h"
#include "kinds/interbus/ring/ring_device.h"

#include <optional>
#include <span>
#include <vector>

namespace codewheel {

class Catalog;

// Whether the ID registers of the two say the same: device code and words.
bool isSameKind(const RingDevice &a, const RingDevice &b);

// Lays the two side by side. Device code, width and place are compared, never the make, which the bus does
// not tell. As many devices as possible are taken to have stayed (the longest common subsequence); of the
// others, those found elsewhere have moved, and what is between the same neighbours differs. A device that
// merely has another number, because one before it is missing, is the same.
Comparison compareRings(const RingStructure &configured, const RingStructure &connected);

// The lines that are the same however the two are laid side by side: no line next to them, or next to
// neighbours of the same device code, has this code and differs. In a row of equal devices with one missing
// nobody can say which it is.
Comparison certainLines(const Comparison &comparison, const RingStructure &configured,
                        const RingStructure &connected);

// "3.0: configured K3 37h, found K2 36h"
QString comparisonText(const ComparisonLine &line, const RingStructure &configured,
                       const RingStructure &connected, const Catalog &catalog);

} // namespace codewheel
