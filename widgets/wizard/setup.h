// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/values_to_write.h"
#include "vocabulary/encoder_session.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/wizard/handshake_record.h"

#include <QPointer>

#include <map>

namespace codewheel {

class Buses;

// What the pages of the wizard pass on to each other.
struct Setup
{
    QPointer<Buses> buses;
    QPointer<EncoderSession> encoder;
    WantedValues &wanted; // shared with the parameter panel
    WriteWish wish;
    struct Given
    {
        std::optional<Value> before;
        std::optional<Value> now;
    };
    std::map<Parameter, Given> given = {}; // by the pages of the wizard
    bool byHand = true;
    bool hasChosenPosition = false; // the user has said whether the position is set
    HandshakeRecord record;

    // The value after the handshake: the wanted one, otherwise the known one.
    std::optional<std::int64_t> valueAfter(Parameter parameter) const
    {
        const auto value = valueOf(wish.wanted, parameter);
        return value ? value : valueNow(parameter);
    }
    std::optional<std::int64_t> valueNow(Parameter parameter) const
    {
        return encoder ? knownNumber(*encoder, parameter) : std::nullopt;
    }
    using Wishes = std::map<Parameter, std::optional<Value>>; // nothing: unchanged

    // After the handshake: the state it was left in, unless somebody or a loss of power has changed that
    // since; whoever has lost sight of the encoder sees it again.
    EncoderState stateNow() const;

    // As one undo step.
    void want(const Wishes &wishes);
    void want(Parameter parameter, const std::optional<Value> &value) { want(Wishes{{parameter, value}}); }
    // Reverts what the pages of the wizard have put among the wanted values; changes made elsewhere since
    // then stay.
    void takeBack();
    QStringList changed() const; // names of what takeBack() would revert
    // From now on they are the user's: nothing is reverted.
    void keep() { given.clear(); }
    void takeWanted() { wish.wanted = encoder ? wanted.values(encoder->place()) : ParameterValues{}; }
};

} // namespace codewheel
