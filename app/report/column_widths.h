// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <vector>

namespace codewheel {

// How much of `room` each column gets that would like so much: those that want little get it, the others
// share what is left. Where there is more than all want together, each gets more in proportion.
std::vector<qreal> columnWidths(const std::vector<qreal> &wanted, qreal room);

} // namespace codewheel
