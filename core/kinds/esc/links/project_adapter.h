// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/plan/esc_line_plan.h"
#include "links/kept_adapter.h"

namespace codewheel {

// The adapter that a project has for its serial line, to open a SerialPortLink with; whichever is at its port
// if it has none.
KeptAdapter keptAdapterOf(const EscLinePlan &line);

// What a project stores of an adapter; empty for a port without one.
EscLineAdapter lineAdapter(const std::optional<PortInfo> &adapter);

} // namespace codewheel
