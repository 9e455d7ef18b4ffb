// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <cstdint>

namespace codewheel {

// ENCOM profile 71 (FRABA manual 2.1), the words of the TR LA-66, and the serial protocol of Kübler, which
// has no words and no ID code.
enum class Profile : std::uint8_t { k1, k2, k3, k4, la66, esc };

QString profileName(Profile profile); // "K1" .. "K4", "LA-66", "ESC"
const QStringList &profileNames();    // in the order of the profiles

} // namespace codewheel
