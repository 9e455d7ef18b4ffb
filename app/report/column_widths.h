// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <vector>

namespace codewheel {

// The widths of columns that want this much of `room`: those that want little get it, the others share what
// is left. If there is more room than all of them want, each gets more in proportion.
std::vector<qreal> columnWidths(const std::vector<qreal> &wanted, qreal room);

} // namespace codewheel
