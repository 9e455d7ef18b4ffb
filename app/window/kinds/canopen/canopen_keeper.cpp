// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/canopen_keeper.h"

#include "app/window/kinds/canopen/canopen_at_work.h"

namespace codewheel {

CanopenKeeper::CanopenKeeper(const CanopenAtWork &bus, QObject *parent)
    : AskedBusKeeper(bus, parent)
    , m_bus(bus)
{}

KindData CanopenKeeper::asOpened() const
{
    return KindData(CanopenPlan{m_bus.openedWith()});
}

void CanopenKeeper::keepLink(const CanopenSettings &settings)
{
    edit(KindData(CanopenPlan{settings}), tr("CAN bus"));
}

} // namespace codewheel
