// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// "0.010 mm per step"
QString resolution(double mmPerStep);

} // namespace codewheel
