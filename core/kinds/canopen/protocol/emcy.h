// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/octets.h"

#include <QStringList>

#include <array>
#include <optional>

namespace codewheel::canopen {

// What a node says of an error that has come or gone (CiA 301, 7.2.7).
struct Emcy
{
    std::uint16_t code = 0;         // 0000: no error any more, or one less
    std::uint8_t errorRegister = 0; // object 1001h
    std::array<std::uint8_t, 5> ofMaker{};

    bool isGone() const { return (code & 0xFF00) == 0; } // one of them; without a bit in the register all

    static std::optional<Emcy> read(Octets data); // empty: it does not have eight bytes
    QString text() const;                         // "8130h, guarding or heartbeat"
    QStringList registerTexts() const;            // "temperature", ...

    friend bool operator==(const Emcy &, const Emcy &) = default;
};

} // namespace codewheel::canopen
