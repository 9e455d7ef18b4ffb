// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/octets.h"

#include <QStringList>

#include <optional>

namespace codewheel::canopen {

// What a node says of an error that has come or gone (CiA 301, 7.2.7).
struct Emcy
{
    std::uint16_t code = 0;         // 0000: no error any more, or one less
    std::uint8_t errorRegister = 0; // object 1001h

    static std::optional<Emcy> read(Octets data); // empty: it does not have eight bytes
    QString text() const;                         // "8130h, guarding or heartbeat"
    QStringList registerTexts() const;            // "temperature", ...
};

} // namespace codewheel::canopen
