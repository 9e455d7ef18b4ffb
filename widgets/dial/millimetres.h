// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// A length for the user, as fine as one step shows: "123.45" where a step is 0.01 mm.
QString millimetres(double length, double millimetresPerStep);

// "0.010 mm per step"
QString resolution(double millimetresPerStep);

} // namespace codewheel
