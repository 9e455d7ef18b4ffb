// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/asked_bus_actions.h"

namespace codewheel {

// The actions for CAN buses only. All CAN buses of a window share them (WindowActions::ofKind()).
class CanopenActions : public AskedBusActions
{
    Q_OBJECT

public:
    explicit CanopenActions(WindowActions &window);

    void showChosen(bool isConnected); // the chosen device: an encoder of a connected CAN bus

    QAction *nodes;
    QAction *unnumbered; // finds a device without a number
    QAction *setup;      // number and rate of the chosen encoder
};

} // namespace codewheel
