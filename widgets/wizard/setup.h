// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/values_to_write.h"
#include "encoder/encoder_session.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/wizard/handshake_record.h"

#include <QPointer>

namespace codewheel {

class ConnectedEncoders;

// What the pages of the wizard hand on to each other.
struct Setup
{
    QPointer<ConnectedEncoders> connected;
    QPointer<EncoderSession> encoder;
    WantedValues &wanted; // shared with the parameter panel
    WriteWish wish;
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
    void want(Parameter parameter, std::optional<std::int64_t> value)
    {
        wanted.set(encoder->number(), parameter, value);
        takeWanted();
    }
    void takeWanted() { wish.wanted = encoder ? wanted.values(encoder->number()) : ParameterValues{}; }
};

} // namespace codewheel
