// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/fault.h"
#include "vocabulary/reading.h"

#include <QStringList>

namespace codewheel {

class EscLineSession;

// What is wrong with a serial line: its port, then its encoders, in the order of their addresses.
std::vector<Fault> lineFaults(const EscLineSession &line);

// The warnings that somebody has to do something about; the others only say how the shaft turns and where it
// is.
QStringList troubles(const Reading &reading);

} // namespace codewheel
