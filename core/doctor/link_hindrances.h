// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "doctor/hindrance.h"
#include "links/computer.h"
#include "vocabulary/refusal.h"

#include <optional>

namespace codewheel {

// What keeps this serial port ("/dev/ttyUSB0") from being used, or makes it slow. It is not opened, since
// that would already act on its modem lines.
Hindrances portHindrances(const QString &path, const Computer &computer);

Hindrance rightsHindrance(const QString &path, const Computer &computer);
// Who has it open or has locked it. Empty: nobody is seen to.
std::vector<Hindrance> holderHindrances(const QString &path, const Computer &computer);

// Whether this user's server may not listen at a port of TCP.
Hindrances serverPortHindrances(int port, Hindrance::Weight weight, const Computer &computer);

Hindrance privilegedPortHindrance(int port, Hindrance::Weight weight, const Computer &computer);

// Adapters that are plugged in but have no port, and programs that get in the way of those that have one.
Hindrances usbHindrances(const Computer &computer);

// CAN interfaces that are switched off.
Hindrances canHindrances(const Computer &computer);

// Why a link to a CAN bus was refused; empty: there is nothing more to say about it.
std::optional<Hindrance> canHindranceOf(const Refusal &why);

} // namespace codewheel
