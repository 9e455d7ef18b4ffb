// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "doctor/hindrance.h"
#include "links/computer.h"
#include "vocabulary/refusal.h"

#include <optional>

namespace codewheel {

// CAN interfaces that are switched off.
Hindrances canHindrances(const Computer &computer);

// Why a link to a CAN bus was refused; empty: there is nothing more to say about it.
std::optional<Hindrance> canHindranceOf(const Refusal &why);

} // namespace codewheel
