// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"

namespace codewheel::test {

// An encoder on the serial line of a project, as the user planned it.
inline ProjectDevice plannedEncoder(Place number, const QString &station = {})
{
    ProjectDevice planned;
    planned.standAt(number);
    planned.participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
    planned.station = station;
    return planned;
}

} // namespace codewheel::test
