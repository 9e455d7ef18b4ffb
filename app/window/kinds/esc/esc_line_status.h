// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/asked_bus_views.h"

#include <QCoreApplication>

namespace codewheel {

class EscLineSession;

// What the status line shows of a serial line: port, baud rate, and who answers. Used by EscLineViews.
class EscLineStatus
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLineStatus)

public:
    static ShownStatus of(const EscLineSession &session); // which is open
};

} // namespace codewheel
