// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/computer.h"

namespace codewheel {

// The file by which programs keep a serial port for themselves. Qt writes one too, and opens no port that
// another program has locked.

// The program that has locked the port, if what it has open cannot be seen: then nothing else tells.
std::optional<Process> lockerOf(const QString &path, const Computer &computer);

// The lock of a program that has ended, which nobody but its user may remove. Empty: there is none.
QString staleLock(const QString &path, const Computer &computer);

} // namespace codewheel
