// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/data_type.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace codewheel::canopen {

// The octets of a value as it is typed for an object: a whole number in decimal or as 1388h, a real one, a
// text, or else hexadecimal digits. Numbers are `width` octets wide; 0: as wide as the type. Empty: it is no
// such value, or does not fit.
std::optional<std::vector<std::uint8_t>> octetsTyped(const QString &typed, std::optional<DataType> type,
                                                     std::size_t width);

} // namespace codewheel::canopen
