// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/serial_ports.h"
#include "widgets/connect/port_row.h"

#include <vector>

namespace codewheel {

// The serial ports as listed in the settings form, and a sentence for it: there is none, or one of them
// cannot be opened, and why; empty: nothing to say.
struct PortRows
{
    std::vector<PortRow> rows;
    QString trouble;
};
// One row per port, with everything its adapter reports; in English.
QStringList adapterRows();
PortRows portRows(const std::vector<PortInfo> &ports);

} // namespace codewheel
