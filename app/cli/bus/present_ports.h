// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace codewheel {

// "ttyUSB0": the serial ports of this computer as they are typed. Opens none.
QStringList presentPortNames();

// The serial ports of this computer in a sentence, or that it has none.
QString presentPortsText();

} // namespace codewheel
