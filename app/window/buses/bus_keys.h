// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt>

// The keys for connecting and leaving the bus that is chosen, of whichever kind it is.
namespace codewheel::bus_keys {

inline constexpr QKeyCombination connection = Qt::ALT | Qt::SHIFT | Qt::Key_C; // its page
inline constexpr QKeyCombination connectBus = Qt::CTRL | Qt::Key_F5;
inline constexpr QKeyCombination disconnectBus = Qt::CTRL | Qt::SHIFT | Qt::Key_F5;

} // namespace codewheel::bus_keys
