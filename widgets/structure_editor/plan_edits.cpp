// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure_editor/plan_edits.h"

#include "project/project_take_over.h"
#include "project/ring_plan.h"
#include "ring/comparison.h"
#include "ring/ring_tree.h"
#include "widgets/structure_editor/plan_row.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The context of these texts.
struct StructureSteps
{
    Q_DECLARE_TR_FUNCTIONS(StructureSteps)
};

} // namespace

RingStructure PlanEdits::structure() const
{
    return structureOf(m_document.project(), m_ring);
}

const Participant &PlanEdits::participant(Id device) const
{
    return m_document.device(device)->participant;
}

QString PlanEdits::nameOf(Id device) const
{
    return participant(device).number.toString();
}

std::optional<RingPlace> PlanEdits::placeOf(Id device) const
{
    const auto place = m_document.indexOf(device);
    return place ? std::optional(codewheel::placeOf(structure(), *place)) : std::nullopt;
}

Result<void> PlanEdits::apply(const Result<EditedRing> &edited, const QString &what)
{
    if (!edited)
        return tl::unexpected(edited.error());
    Project after = m_document.project();
    setRingPlan(after, m_ring, ringPlan(after, m_ring));
    const std::span<ProjectDevice> before = devicesOn(after, m_ring);
    std::vector<ProjectDevice> devices;
    for (std::size_t i = 0; i < edited->structure.size(); ++i) {
        const auto from = edited->from[i];
        ProjectDevice device = from ? std::move(before[*from]) : ProjectDevice();
        device.bus = m_ring;
        device.participant = edited->structure[i];
        devices.push_back(std::move(device));
    }
    setDevicesOn(after, m_ring, std::move(devices));
    m_document.edit(std::move(after), m_ring, edited->from, what);
    return {};
}

Result<PlanEdits::Id> PlanEdits::insert(const Participant &device, const RingPlace &place)
{
    const auto edited = insertDevice(structure(), device, place);
    const auto done = apply(edited, StructureSteps::tr("Insert %1").arg(planName(device, m_catalog)));
    if (!done)
        return tl::unexpected(done.error());
    const auto at =
        std::ranges::find_if(edited->from, [](const auto &from) { return !from; }) - edited->from.begin();
    return m_document.ids(m_ring)[static_cast<std::size_t>(at)];
}

Result<void> PlanEdits::remove(const Ids &devices)
{
    if (devices.empty())
        return {};
    std::vector<std::size_t> places;
    for (const Id device : devices)
        if (const auto place = m_document.indexOf(device))
            places.push_back(*place);
    const QString what = places.size() == 1 ? StructureSteps::tr("Remove %1").arg(nameOf(devices.front()))
                                            : StructureSteps::tr("Remove %n devices", nullptr,
                                                                 static_cast<int>(places.size()));
    return apply(removeDevices(structure(), places), what);
}

Result<void> PlanEdits::move(const Ids &devices, const RingPlace &place)
{
    if (devices.empty())
        return {};
    std::vector<std::size_t> places;
    for (const Id device : devices)
        if (const auto at = m_document.indexOf(device))
            places.push_back(*at);
    const QString what =
        places.size() == 1 ? StructureSteps::tr("Move %1").arg(nameOf(devices.front()))
                           : StructureSteps::tr("Move %n devices", nullptr, static_cast<int>(places.size()));
    return apply(moveDevices(structure(), places, place), what);
}

Result<void> PlanEdits::change(Id device, const Participant &to)
{
    const std::size_t place = *m_document.indexOf(device);
    const QString what = StructureSteps::tr("Change %1 to %2").arg(nameOf(device), planName(to, m_catalog));
    auto edited = changeDevice(structure(), place, to);
    if (!edited)
        return tl::unexpected(edited.error());
    Project after = m_document.project();
    const std::span<ProjectDevice> devices = devicesOn(after, m_ring);
    for (std::size_t i = 0; i < edited->structure.size(); ++i)
        devices[i].participant = edited->structure[i];
    ProjectDevice &changed = devices[place];
    const bool isSame = isSameKind(participant(device), to) && participant(device).deviceKey == to.deviceKey;
    if (!isSame) {
        changed.label = {};
        changed.wanted.clear();
        changed.wantedCams.clear();
        changed.stored.clear();
        changed.storedCams.clear();
        changed.lastPosition.reset();
    }
    m_document.edit(std::move(after), what);
    return {};
}

Result<void> PlanEdits::moveBy(Id device, int rows)
{
    RingPlace place = *placeOf(device);
    if (rows < 0 && place.row == 0)
        return {};
    // Behind the neighbour: the row is counted with the device where it stands.
    place.row = rows < 0 ? place.row - 1 : place.row + 2;
    return move({device}, place);
}

Result<void> PlanEdits::moveIn(Id device)
{
    const RingTree tree = ringTree(structure());
    const std::size_t at = *m_document.indexOf(device);
    const std::size_t row = tree.rowOf(at);
    if (row == 0 || tree.nodes[at].isLocal)
        return {};
    const std::size_t before = tree.busOf(at)[row - 1];
    const bool isLocal = prefersLocalBus(participant(device));
    const RingTree::Node &terminal = tree.nodes[before];
    return move({device}, {.terminal = before,
                           .onLocalBus = isLocal,
                           .row = isLocal ? terminal.localBus.size() : terminal.branch.size()});
}

Result<void> PlanEdits::moveOut(Id device)
{
    const RingPlace place = *placeOf(device);
    if (!place.terminal)
        return {};
    RingPlace behind = codewheel::placeOf(structure(), *place.terminal);
    ++behind.row;
    return move({device}, behind);
}

Result<void> PlanEdits::changeBus(Id device)
{
    RingPlace place = *placeOf(device);
    if (!place.terminal)
        return {};
    const RingTree tree = ringTree(structure());
    const RingTree::Node &terminal = tree.nodes[*place.terminal];
    place.onLocalBus = !place.onLocalBus;
    place.row = place.onLocalBus ? terminal.localBus.size() : 0;
    return move({device}, place);
}

} // namespace codewheel
