// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "serial/byte_link.h"
#include "vocabulary/port_text.h"

namespace codewheel {

// The port as messages and refusals store it.
inline QString portArgument(const ByteLink &link)
{
    return link.isSimulated() ? QString(trainingPort) : link.name();
}

} // namespace codewheel
