// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/simulator/canopen_encoder_plan.h"

#include <span>

namespace codewheel::canopen {

// A quirk that a simulated encoder can be given, at the command line or by a trainer.
struct NamedQuirk
{
    const char *key; // "fixed-mapping"
    bool (*isIn)(const NodeQuirks &quirks);
    void (*put)(NodeQuirks &quirks, bool on);
};

// In the order of their keys.
std::span<const NamedQuirk> namedQuirks();

} // namespace codewheel::canopen
