// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// The serial ports of this computer in a sentence, or that it has none.
QString presentPortsText();

} // namespace codewheel
