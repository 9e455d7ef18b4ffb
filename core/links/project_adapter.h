// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/kept_adapter.h"
#include "project/project.h"

namespace codewheel {

// The adapter that a project has for its serial line, to open a SerialPortLink with; whichever is at its port
// where it has none.
KeptAdapter keptAdapterOf(const ProjectLine &line);

// What a project keeps of the adapter at this port, by name or path; nothing of a port without one.
LineAdapter adapterAt(const QString &port, const std::vector<PortInfo> &present);

} // namespace codewheel
