// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/spoken_protocol.h"

namespace codewheel {

// Encoders with the Kübler ESC protocol: 19200, 9600 or 4800 Bd, 8N2. Any encoder answers at the master
// address 00 (manual, "Masteraddress: 00"), so that one request per baud rate finds out where there are any.
std::unique_ptr<const SpokenProtocol> makeEscProtocol();

// That of the factory first.
std::vector<SerialSettings> usualEscSettings();
// How to connect with a line, with or without a master.
Found escLineAt(const QString &port, const SerialSettings &settings, const QString &sentence);
// First at the master address at each rate, then at every address where anything came.
std::unique_ptr<Asking> askForEncoders(const QString &port);

} // namespace codewheel
