// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

#include <QByteArray>

#include <optional>

namespace codewheel {

// The letters of the commands that read and write a parameter; empty: none does. Direction and scaling are
// one bit of an answer.
struct EscReach
{
    QByteArray read{};
    std::optional<unsigned> bit{}; // of the answer; empty: all of it
    QByteArray write{};

    friend bool operator==(const EscReach &, const EscReach &) = default;
};

// None, if it is reached in another way, or not at all.
inline EscReach escReach(const ParameterDescription &parameter)
{
    const auto *reach = parameter.reach.as<EscReach>();
    return reach != nullptr ? *reach : EscReach();
}

} // namespace codewheel
