// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/kept_adapter.h"
#include "project/line_plan.h"

namespace codewheel {

// The adapter that a project has for its serial line, to open a SerialPortLink with; whichever is at its port
// if it has none.
KeptAdapter keptAdapterOf(const LinePlan &line);

// What a project stores of an adapter; empty for a port without one.
LineAdapter lineAdapter(const std::optional<PortInfo> &adapter);

} // namespace codewheel
