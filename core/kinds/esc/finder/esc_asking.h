// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/spoken_protocol.h"

namespace codewheel {

// That of the factory first.
std::vector<SerialSettings> usualEscSettings();
// How to connect with a line, with or without a master.
Found escLineAt(const QString &port, const SerialSettings &settings, const QString &sentence);
// First at the master address at each rate, then at every address where anything came.
std::unique_ptr<Asking> askForEncoders(const QString &port);

} // namespace codewheel
