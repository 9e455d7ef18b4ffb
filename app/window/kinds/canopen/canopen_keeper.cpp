// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/canopen_keeper.h"

#include "app/window/kinds/canopen/canopen_at_work.h"
#include "widgets/project/project_document.h"

namespace codewheel {

CanopenKeeper::CanopenKeeper(const CanopenAtWork &bus, QObject *parent)
    : AskedBusKeeper(bus, {tr("CAN bus"), tr("Encoders of the CAN bus")}, parent)
    , m_bus(bus)
{}

void CanopenKeeper::keepFile(int node, const QString &path)
{
    ProjectDocument &project = m_bus.project();
    const Place place{m_bus.id(), CanopenAddress{node}.place()};
    if (findDevice(project.project(), place) != nullptr)
        project.editDevice(place, tr("Objects of %1").arg(place.shown()), [&](ProjectDevice &encoder) {
            encoder.set(CanopenEncoderSettings{.file = path});
        });
}

// What is planned for a training encoder is in no file, but still moves along.
void CanopenKeeper::moveEncoder(Place from, Place to)
{
    if (m_bus.training() != nullptr && findDevice(m_bus.project().project(), from) != nullptr)
        return;
    m_bus.project().renumber(from, to, tr("Number of %1 to %2").arg(from.shown(), to.shown()));
}

} // namespace codewheel
