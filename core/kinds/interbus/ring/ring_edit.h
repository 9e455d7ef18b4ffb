// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"
#include "vocabulary/refusal.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace codewheel {

// Where a device is in a ring: below which bus terminal, on its local bus or in its branch.
struct RingPlace
{
    std::optional<std::size_t> terminal; // its index in ring order; empty: on the main line
    bool onLocalBus = false;
    std::size_t row = 0; // among the devices there; as many as there are, or more: at the end

    friend bool operator==(const RingPlace &, const RingPlace &) = default;
};
RingPlace placeOf(const RingStructure &structure, std::size_t device);

// A structure after an edit, with new numbers and levels.
struct EditedRing
{
    RingStructure structure;
    std::vector<std::optional<std::size_t>> from; // where each was before; empty: it is new

    friend bool operator==(const EditedRing &, const EditedRing &) = default;
};

// Edits of a planned ring. Each leaves it as valid as it was: what would break a rule (ring_rules.h)
// that holds now, or break it further, is refused in words (structureBroken). Devices are given by their
// indices in ring order.
Result<EditedRing> insertDevice(const RingStructure &structure, const RingDevice &device,
                                const RingPlace &place);
// With everything below them.
Result<EditedRing> removeDevices(const RingStructure &structure, std::span<const std::size_t> devices);
// With everything below them, one after the other. The row counts the devices where they are now.
Result<EditedRing> moveDevices(const RingStructure &structure, std::span<const std::size_t> devices,
                               const RingPlace &place);
// Another kind of device in its place.
Result<EditedRing> changeDevice(const RingStructure &structure, std::size_t device, const RingDevice &to);

} // namespace codewheel
