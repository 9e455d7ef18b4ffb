// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/canopen_keeper.h"

#include "app/window/kinds/canopen/canopen_at_work.h"
#include "widgets/project/project_document.h"

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

void CanopenKeeper::keepFile(int node, const QString &path)
{
    ProjectDocument &project = m_bus.project();
    const Place place{m_bus.id(), CanopenAddress{node}.place()};
    if (findDevice(project.project(), place) != nullptr)
        project.editDevice(place, tr("Objects of %1").arg(place.shown()), [&](ProjectDevice &encoder) {
            encoder.set(CanopenEncoderSettings{.file = path});
        });
}

} // namespace codewheel
