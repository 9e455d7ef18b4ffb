// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {

// A serial port as messages and refusals keep it: only the simulated line has a name that depends on the
// language.
inline constexpr QLatin1String trainingPort("training");

inline QString portText(const RefusalArgument &port)
{
    const QString text = argumentText(port);
    return text == trainingPort ? QCoreApplication::translate("SimulatedEscLine", "training line") : text;
}

} // namespace codewheel
