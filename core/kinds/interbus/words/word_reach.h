// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

#include <optional>

namespace codewheel {

// What a parameter of an encoder with words is written and read with.
struct WordReach
{
    std::optional<unsigned> number{}; // D28..D25 of the word that writes it, or its service; empty: read only
    std::optional<unsigned> readOut{}; // code of 2021000nh, or the service; empty: it cannot be read

    friend bool operator==(const WordReach &, const WordReach &) = default;
};

// Neither, if it is reached in another way, or not at all.
WordReach wordReach(const ParameterDescription &parameter);
// Null: the device has none.
const ParameterDescription *findNumber(const DeviceDescription &device, unsigned number);
const ParameterDescription *findReadOut(const DeviceDescription &device, unsigned code);

} // namespace codewheel
