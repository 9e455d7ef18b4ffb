// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/instant.h"
#include "encoder/parameter.h"

namespace codewheel {

// How we came to know a value. Strongest first; a value without evidence is unknown and is never shown as a
// default.
enum class Evidence : std::uint8_t {
    read,   // the encoder told it (read-out)
    echoed, // the handshake confirmed it and run was answered by undisturbed operation
    told,   // the user, or the plan of the training bus, said so
};

struct Known
{
    Parameter parameter = Parameter::steps;
    std::int64_t value = 0;
    Evidence evidence = Evidence::told;
    Instant at{};

    friend bool operator==(const Known &, const Known &) = default;
};

} // namespace codewheel
