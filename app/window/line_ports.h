// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/line/line_wish.h"

#include <vector>

namespace codewheel {

// The serial ports of this computer as the settings form lists them, and a sentence that stands there: there
// is none, or one of them cannot be opened, and why; empty: nothing to say.
struct LinePorts
{
    std::vector<PortRow> rows;
    QString trouble;
};
LinePorts linePorts();

} // namespace codewheel
