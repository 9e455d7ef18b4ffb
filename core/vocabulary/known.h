// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/parameter.h"

namespace codewheel {

// How a value came to be known, strongest first. A value without evidence is unknown; no default is ever
// shown in its place.
enum class Evidence : std::uint8_t {
    read,   // the encoder reported it (read-out)
    echoed, // the handshake confirmed it and after run the encoder returned undisturbed to operation
    told,   // given by the user, or by the plan of the training bus
};

// Whether a value in force is in force again after the encoder was without supply.
enum class Kept : std::uint8_t {
    byItself,      // nothing to say: this encoder keeps what is in force, or nobody writes it
    notKnown,      // only read, or nobody has seen the answer to the step that stores
    untilPowerOff, // not stored yet, or never
    stored,
};

struct Known
{
    Parameter parameter = Parameter::steps;
    Value value = 0;
    Evidence evidence = Evidence::told;
    Instant at{};
    Kept kept = Kept::byItself;

    friend bool operator==(const Known &, const Known &) = default;
};

} // namespace codewheel
