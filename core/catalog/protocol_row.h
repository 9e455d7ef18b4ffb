// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

namespace codewheel {

// What an LA-66 or an encoder on a serial line has for a parameter, which its protocol fixes: a service that
// moves the position must not pass for one that stores a value. Used by the rules of a description.
struct ProtocolRow
{
    Parameter parameter = Parameter::steps;
    // LA-66: the services that write and read it (LA-66 manual 3).
    std::optional<unsigned> number{};
    std::optional<unsigned> readOut{};
    // Serial line: the commands (Kübler manual, ESC commands overview).
    std::optional<esc::Command> readCommand{};
    std::optional<unsigned> readBit{};
    std::optional<esc::Command> writeCommand{};
};

// With nothing in it where the protocol does not have the parameter, and for a profile without such rows.
ProtocolRow protocolRow(Profile profile, Parameter parameter);

} // namespace codewheel
