// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "doctor/hindrance.h"
#include "links/computer.h"

namespace codewheel {

// Whether this user's server may not listen at a port of TCP.
Hindrances serverPortHindrances(int port, Hindrance::Weight weight, const Computer &computer);

Hindrance privilegedPortHindrance(int port, Hindrance::Weight weight, const Computer &computer);

} // namespace codewheel
