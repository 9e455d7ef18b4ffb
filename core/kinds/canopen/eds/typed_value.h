// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/device_file.h"
#include "kinds/canopen/eds/file_value.h"
#include "kinds/canopen/protocol/octets.h"

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

// The limit of the file that the value is beyond. Empty: none, as far as they are known.
std::optional<FileValue> limitBroken(const FileObject &object, const FileValue &value,
                                     std::optional<int> node);

// What a device has answered for an object, as a device file has it: numbers by the sign of their type and
// the width of the answer, octets as hexadecimal digits.
FileValue fileValueOf(std::optional<DataType> type, Octets octets);

} // namespace codewheel::canopen
