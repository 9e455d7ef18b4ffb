// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "doctor/hindrance.h"
#include "links/computer.h"

namespace codewheel {

// What keeps this serial port ("/dev/ttyUSB0") from being used, or makes it slow. It is not opened, since
// that would already act on its modem lines.
Hindrances portHindrances(const QString &path, const Computer &computer);

Hindrance rightsHindrance(const QString &path, const Computer &computer);
// Who has it open or has locked it. Empty: nobody is seen to.
std::vector<Hindrance> holderHindrances(const QString &path, const Computer &computer);

} // namespace codewheel
