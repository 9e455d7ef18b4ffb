// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"

#include <cstddef>

namespace codewheel {

// Something wrong with a planned bus, as shown while it is edited.
struct Finding
{
    Severity severity = Severity::fault;
    std::size_t device = 0; // its index on the bus
    QString text;           // a sentence in the user's language

    friend bool operator==(const Finding &, const Finding &) = default;
};

} // namespace codewheel
