// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/canopen_keeper.h"

#include "app/window/kinds/canopen/canopen_at_work.h"
#include "widgets/project/project_document.h"

#include <algorithm>

namespace codewheel {

CanopenKeeper::CanopenKeeper(const CanopenAtWork &bus, ProjectDocument &project, QObject *parent)
    : QObject(parent)
    , m_bus(bus)
    , m_project(project)
{}

std::vector<ProjectDevice> CanopenKeeper::encoders() const
{
    const auto planned = devicesOn(m_project.project(), m_bus.id());
    return {planned.begin(), planned.end()};
}

void CanopenKeeper::keepLink(const CanopenSettings &settings)
{
    Project project = m_project.project();
    setCanopenPlan(project, m_bus.id(), {settings});
    m_project.edit(std::move(project), tr("CAN bus"));
}

void CanopenKeeper::edit(std::vector<ProjectDevice> after, const QString &what)
{
    Project project = m_project.project();
    if (canopenPlan(project, m_bus.id()) == nullptr)
        setCanopenPlan(project, m_bus.id(), {m_bus.openedWith()});
    setDevicesOn(project, m_bus.id(), std::move(after));
    m_project.edit(std::move(project), what);
}

void CanopenKeeper::keepEncoders(const std::vector<Place> &places)
{
    if (m_bus.training() != nullptr || m_bus.session() == nullptr || places.empty())
        return;
    std::vector<ProjectDevice> after = encoders();
    for (const Place place : places) {
        const auto behind = std::ranges::lower_bound(after, place, {}, &ProjectDevice::place);
        const EncoderSession *connected = m_bus.session()->encoder(place);
        if (connected == nullptr || (behind != after.end() && behind->place() == place))
            continue;
        ProjectDevice encoder;
        encoder.standAt(place);
        encoder.participant.deviceKey = connected->device().key;
        after.insert(behind, std::move(encoder));
    }
    edit(std::move(after), tr("Encoders of the CAN bus"));
}

void CanopenKeeper::removeEncoder(Place place)
{
    if (m_bus.training() != nullptr || canopenPlan(m_project.project(), m_bus.id()) == nullptr)
        return;
    std::vector<ProjectDevice> after = encoders();
    std::erase_if(after, [place](const ProjectDevice &encoder) { return encoder.place() == place; });
    edit(std::move(after), tr("Remove %1").arg(place.shown()));
}

} // namespace codewheel
