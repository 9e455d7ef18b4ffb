// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/own_kind.h"
#include "vocabulary/parameter.h"
#include "vocabulary/word.h"

#include <QByteArray>

#include <optional>
#include <vector>

namespace codewheel {

// What a step does to the encoder. Progress, EEPROM writes and the ways back follow from it, whatever the
// protocol.
enum class Effect : std::uint8_t {
    none,  // it prepares or ends another
    reads, // a value, or ends a reading
    readsCams,
    takes,        // the encoder takes a value; whether it is in force at once, its protocol says
    takesCams,    // the encoder takes a word of a cam program
    byHand,       // a word of the user, whatever it does
    takesByHand,  // one that gives the encoder a value
    activates,    // what it has taken is in force from now on
    stores,       // what is in force is kept without supply: one EEPROM write, where taking costs none
    setsPosition, // to what it has as a preset
    switchesMode, // a cam program that was changed is stored
};

struct Step
{
    Effect effect = Effect::none;
    OwnKind kind{};                      // of its protocol
    Word out = 0;                        // the word this step puts into OUT
    std::vector<Parameter> parameters{}; // that it reads or writes, where the description names them
    QByteArray line{};                   // what is sent instead of a word: "03GP00005200"
    std::optional<std::int64_t> data{};  // the value that a line writes, as sent

    // For protocols whose steps carry one at most.
    std::optional<Parameter> parameter() const
    {
        return parameters.empty() ? std::nullopt : std::optional(parameters.front());
    }

    friend bool operator==(const Step &, const Step &) = default;
};

} // namespace codewheel
