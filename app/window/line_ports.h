// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/serial_ports.h"
#include "widgets/line/port_row.h"

#include <vector>

namespace codewheel {

// The serial ports there are as the settings form lists them, and a sentence that stands there: there
// is none, or one of them cannot be opened, and why; empty: nothing to say.
struct LinePorts
{
    std::vector<PortRow> rows;
    QString trouble;
};
// One a row, with all it tells of its adapter; in English.
QStringList adapterRows();
LinePorts linePorts(const std::vector<PortInfo> &ports);

} // namespace codewheel
