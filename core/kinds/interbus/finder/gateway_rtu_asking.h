// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/spoken_protocol.h"

namespace codewheel {

// The most usual ones first.
std::vector<SerialSettings> usualRtuSettings();

struct RtuUnit
{
    int unit = 1;
    bool hasInput = true; // registers; otherwise holding registers
};
// How to connect with a unit, with or without a master.
Found gatewayAt(const QString &port, const SerialSettings &serial, RtuUnit unit, const QString &sentence);
// Each unit is asked for its first input register, and if it has none, for its first holding register. It is
// there once two answers agree.
std::unique_ptr<Asking> askForUnits(const QString &port);

} // namespace codewheel
