// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/data_type.h"
#include "kinds/canopen/eds/eds_fault.h"

#include <QString>

#include <string_view>
#include <variant>

namespace codewheel::canopen {

// A default, a limit or a value in a device file.
struct FileValue
{
    std::variant<std::int64_t, double, QString> value; // of a u64 the bits
    bool addsNode = false;                             // the number of the node is to be added: $NODEID+384

    const std::int64_t *number() const { return std::get_if<std::int64_t>(&value); }
    // With the number of the node added, where it is known. Empty: it is needed, and not known.
    std::optional<FileValue> at(std::optional<int> node) const;
    // As a file has it: "384", "$NODEID+384", "1.5", a text.
    QString text(std::optional<DataType> type) const;

    friend bool operator==(const FileValue &, const FileValue &) = default;
};

// What became of a text in a device file.
struct ReadValue
{
    std::optional<FileValue> value{};
    std::optional<EdsFault> fault{}; // otherwise than written, or, without a value, why there is none
    QStringList parts{};             // of its sentence
};

// By the type of its object: hexadecimal numbers of signed types are two's complement, a leading zero does
// not make a number octal, texts lose their quotes. `type` empty: it is not known; what is no number is a
// text.
ReadValue readFileValue(std::string_view text, std::optional<DataType> type);

// A number of any size up to 64 bits, for keys that count or choose. Without a fault: it is plain.
struct ReadNumber
{
    std::optional<std::uint64_t> magnitude{};
    bool isNegative = false;
    bool isHexadecimal = false;
    bool isTooLarge = false; // it is a number, of more than 64 bits
    std::optional<EdsFault> fault{};
};
ReadNumber readFileNumber(std::string_view text);

} // namespace codewheel::canopen
