// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/asked_bus_keeper.h"
#include "kinds/canopen/plan/canopen_plan.h"

namespace codewheel {

class CanopenAtWork;

// What is kept of a CAN bus. Used by CanopenViews.
class CanopenKeeper : public AskedBusKeeper
{
    Q_OBJECT

public:
    explicit CanopenKeeper(const CanopenAtWork &bus, QObject *parent = nullptr); // which must outlive it

    // Of an encoder of the project: that its objects are taken from this EDS or DCF.
    void keepFile(int node, const QString &path);
    // Everything planned and known of the encoder moves along.
    void moveEncoder(Place from, Place to);

private:
    const CanopenAtWork &m_bus;
};

} // namespace codewheel
