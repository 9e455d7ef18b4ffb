// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "serial/byte_link.h"
#include "vocabulary/refusal.h"

namespace codewheel {

// The port as messages store it: only the simulated line has a name that depends on the language.
inline RefusalArgument portArgument(const ByteLink &link)
{
    return link.isSimulated() ? QStringLiteral("training") : link.name();
}

} // namespace codewheel
