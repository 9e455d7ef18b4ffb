// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/bus_sections.h"

namespace codewheel::report_sections {

// The devices of a ring with their addresses in the process image, and about how long a bus cycle takes, by
// both formulas.
extern const BusSections ofRings;

} // namespace codewheel::report_sections
