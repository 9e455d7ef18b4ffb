// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/asked_bus_views.h"

#include <QCoreApplication>

namespace codewheel {

class CanopenSession;

// What the status line shows of a CAN bus: interface, rate, load, and who is heard. Used by CanopenViews.
class CanopenStatus
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenStatus)

public:
    static ShownStatus of(const CanopenSession &session); // which is open
};

} // namespace codewheel
