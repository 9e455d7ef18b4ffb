// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/plan/ring_plan.h"

#include <QStringView>

namespace codewheel {

// Where a device is in the process image of one direction.
struct AddressRange
{
    int first = 0; // byte
    int bytes = 0;
    bool byHand = false;

    int last() const { return first + bytes - 1; }
    friend bool operator==(const AddressRange &, const AddressRange &) = default;
};
struct DeviceAddresses
{
    std::optional<AddressRange> in; // empty: it has no such words
    std::optional<AddressRange> out;

    friend bool operator==(const DeviceAddresses &, const DeviceAddresses &) = default;
};

inline constexpr int largestAddress = 65'535; // byte, for addresses given by hand

// For each device in ring order. Automatic ones follow each other from AddressRules::first on, word-aligned,
// and skip those given by hand. IN and OUT are counted separately.
std::vector<DeviceAddresses> processAddresses(const Project &project, BusId ring = firstBus);

// As shown and typed: a byte or a word number. In words, an odd byte is shown as "6 + 1".
QString addressText(int byte, AddressRules::Unit unit);
// In bytes; empty for anything but a number within 0..largestAddress.
std::optional<int> parseAddress(QStringView text, AddressRules::Unit unit);

} // namespace codewheel
