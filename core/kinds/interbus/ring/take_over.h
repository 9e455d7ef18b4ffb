// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/comparison.h"

namespace codewheel {

// One device of a ring that took over lines of another: from its own ring, the other, or both if it stays
// itself and takes place, level and code from there.
struct TakenDevice
{
    std::optional<std::size_t> own;
    std::optional<std::size_t> other;

    friend bool operator==(const TakenDevice &, const TakenDevice &) = default;
};

// What the configured ring consists of once the lines with these indices are taken over from the connected
// one, in ring order. Other lines stay as they are. With all lines: the order of the connected ring.
std::vector<TakenDevice> takeOver(const Comparison &comparison, std::span<const std::size_t> lines);

// The same with the sides swapped, to take over from the configured ring.
Comparison mirrored(Comparison comparison);

// A device of takeOver(). Its make stays known if it is of the same kind.
RingDevice takenParticipant(const TakenDevice &device, const RingStructure &own, const RingStructure &other);
// The ring with those lines taken over, devices numbered by their places.
RingStructure takenOver(const RingStructure &own, const RingStructure &other, const Comparison &comparison,
                        std::span<const std::size_t> lines);

} // namespace codewheel
