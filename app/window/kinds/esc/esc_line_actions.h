// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/asked_bus_actions.h"

namespace codewheel {

// The actions for serial lines only. All lines of a window share them (WindowActions::ofKind()).
class EscLineActions : public AskedBusActions
{
    Q_OBJECT

public:
    explicit EscLineActions(WindowActions &window);

    // The chosen device: whether it is an encoder on a line, connected, and sends the low byte of its
    // warnings first.
    struct Chosen
    {
        bool isOnLine = false;
        bool isConnected = false;
        bool isSwapped = false;
    };
    void showChosen(Chosen chosen);

    QAction *terminal;
    QAction *figures;
    QAction *swapWarningBytes; // of the chosen encoder; checkable
};

} // namespace codewheel
