// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/asked_bus_keeper.h"

#include "app/window/buses/asked_bus_at_work.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "widgets/project/project_document.h"

#include <algorithm>
#include <utility>

namespace codewheel {

AskedBusKeeper::AskedBusKeeper(const AskedBusAtWork &bus, Steps steps, QObject *parent)
    : QObject(parent)
    , m_bus(bus)
    , m_steps(std::move(steps))
{}

const PlannedBus *AskedBusKeeper::planned() const
{
    const PlannedBus *planned = findBus(m_bus.project().project(), m_bus.id());
    return planned != nullptr && planned->kind == m_bus.kind() ? planned : nullptr;
}

KindData AskedBusKeeper::plan() const
{
    const PlannedBus *its = planned();
    return its != nullptr ? its->settings : m_bus.openedPlan();
}

void AskedBusKeeper::keepLink(const KindData &plan)
{
    edit(m_bus.asOpened(plan), m_steps.link);
}

std::vector<ProjectDevice> AskedBusKeeper::encoders() const
{
    const auto planned = devicesOn(m_bus.project().project(), m_bus.id());
    return {planned.begin(), planned.end()};
}

void AskedBusKeeper::edit(KindData plan, const QString &what)
{
    Project project = m_bus.project().project();
    planBus(project, m_bus.id(), *busKind(m_bus.kind())).settings = std::move(plan);
    m_bus.project().edit(std::move(project), what);
}

void AskedBusKeeper::edit(std::vector<ProjectDevice> after, const QString &what)
{
    Project project = m_bus.project().project();
    if (planned() == nullptr)
        planBus(project, m_bus.id(), *busKind(m_bus.kind())).settings = m_bus.openedPlan();
    setDevicesOn(project, m_bus.id(), std::move(after));
    m_bus.project().edit(std::move(project), what);
}

const EncoderSession *AskedBusKeeper::sessionOf(Place place) const
{
    const bool isKept = m_bus.bus() != nullptr && !m_bus.isSimulatedHere();
    return isKept ? m_bus.bus()->encoder(place) : nullptr;
}

ProjectDevice &AskedBusKeeper::plannedEncoder(std::vector<ProjectDevice> &encoders,
                                              const EncoderSession &connected) const
{
    const auto behind = std::ranges::lower_bound(encoders, connected.place(), {}, &ProjectDevice::place);
    if (behind != encoders.end() && behind->place() == connected.place())
        return *behind;
    ProjectDevice encoder;
    encoder.standAt(connected.place());
    encoder.participant.deviceKey = connected.device().key;
    takeUp(encoder, connected);
    return *encoders.insert(behind, std::move(encoder));
}

void AskedBusKeeper::keepEncoders(const std::vector<Place> &places)
{
    if (m_bus.isSimulatedHere() || places.empty())
        return;
    std::vector<ProjectDevice> after = encoders();
    for (const Place place : places)
        if (const EncoderSession *connected = sessionOf(place))
            plannedEncoder(after, *connected);
    edit(std::move(after), m_steps.encoders);
}

void AskedBusKeeper::removeEncoder(Place place)
{
    if (m_bus.isSimulatedHere() || planned() == nullptr)
        return;
    std::vector<ProjectDevice> after = encoders();
    std::erase_if(after, [place](const ProjectDevice &encoder) { return encoder.place() == place; });
    edit(std::move(after), tr("Remove %1").arg(place.shown()));
}

} // namespace codewheel
