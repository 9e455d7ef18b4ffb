// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace codewheel {

// The addresses at which other computers reach this one now, without those that hold on one cable only
// (fe80::). For the choice where something is offered.
QStringList ownAddresses();

} // namespace codewheel
