// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <cstdint>

namespace codewheel::esc {

struct Answer
{
    enum class Kind : std::uint8_t {
        value,          // digits of a read
        text,           // of the version
        accepted,       // CR LF: a write was executed
        unknownCommand, // 03
        outOfRange,     // 05: incomplete command, or a value out of range
    };

    Kind kind = Kind::value;
    std::uint32_t value = 0; // Kind::value
    QByteArray text;         // what was between the line ends, as received

    friend bool operator==(const Answer &, const Answer &) = default;
};

} // namespace codewheel::esc
