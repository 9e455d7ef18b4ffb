// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/values_to_write.h"
#include "encoder/encoder_session.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/wizard/handshake_record.h"

#include <QPointer>

#include <map>

namespace codewheel {

class Buses;

// What the pages of the wizard hand on to each other.
struct Setup
{
    QPointer<Buses> buses;
    QPointer<EncoderSession> encoder;
    WantedValues &wanted; // shared with the parameter panel
    WriteWish wish;
    struct Given
    {
        std::optional<std::int64_t> before;
        std::optional<std::int64_t> now;
    };
    std::map<Parameter, Given> given = {}; // by the pages of the wizard
    bool byHand = true;
    HandshakeRecord record;

    // The value that will hold after the handshake: wanted, else known.
    std::optional<std::int64_t> valueAfter(Parameter parameter) const
    {
        const auto value = valueOf(wish.wanted, parameter);
        return value ? value : valueNow(parameter);
    }
    std::optional<std::int64_t> valueNow(Parameter parameter) const
    {
        const auto known = encoder ? encoder->known(parameter) : std::nullopt;
        return known ? std::optional(known->value) : std::nullopt;
    }
    using Wishes = std::map<Parameter, std::optional<std::int64_t>>; // nothing: unchanged

    // One step of undo.
    void want(const Wishes &wishes);
    void want(Parameter parameter, std::optional<std::int64_t> value) { want(Wishes{{parameter, value}}); }
    // What the pages of the wizard have put among the wanted values is as it was before; what was changed
    // elsewhere since stays.
    void takeBack();
    QStringList changed() const; // names of what takeBack() would take
    // It is the user's now: nothing is taken back.
    void keep() { given.clear(); }
    void takeWanted() { wish.wanted = encoder ? wanted.values(encoder->place()) : ParameterValues{}; }
};

} // namespace codewheel
