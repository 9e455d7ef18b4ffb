// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "doctor/hindrance.h"
#include "links/computer.h"
#include "vocabulary/refusal.h"

#include <optional>

namespace codewheel {

// Why a link was refused, looked into further than the refusal itself: by whom a port is taken, which command
// gives the rights. Empty: there is nothing more to say about it.
std::optional<Hindrance> hindranceOf(const Refusal &why, const Computer &computer = Computer());

} // namespace codewheel
