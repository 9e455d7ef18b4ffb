// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"
#include "widgets/look/trouble.h"

namespace codewheel {

struct Hindrance;

Trouble troubleOf(const Hindrance &hindrance);
// With what the computer tells about its cause, such as the program that has the port.
Trouble troubleOf(const Refusal &why);

} // namespace codewheel
