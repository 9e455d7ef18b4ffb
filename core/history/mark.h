// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"

#include <QString>

#include <variant>

namespace codewheel {

// What happened at a moment: a message of a bus or of a device on it, or what the user noted there.
struct Mark
{
    Instant at{};                 // since 1970, UTC
    std::optional<Place> place{}; // nothing: it concerns all
    std::variant<Message, QString> what{};

    bool isNote() const { return std::holds_alternative<QString>(what); }
    friend bool operator==(const Mark &, const Mark &) = default;
};

} // namespace codewheel
