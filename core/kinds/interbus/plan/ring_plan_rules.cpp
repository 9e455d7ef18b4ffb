// SPDX-License-Identifier: GPL-3.0-or-later
// What can be done to a planned ring.
#include "kinds/interbus/plan/ring_plan_rules.h"

#include "catalog/catalog.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/ring/comparison.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/ring_strangers.h"
#include "kinds/interbus/ring/ring_tree.h"
#include "kinds/interbus/ring/take_over.h"

namespace codewheel {
namespace {

// Whether it belongs on a local bus: it is on one, or its ID code says so.
bool prefersLocalBus(const RingDevice &device)
{
    return isOnLocalBus(device) || standsOnLocalBus(device.idCode());
}

Result<EditedPlan> asPlan(const Project &project, BusId ring, Result<EditedRing> edited)
{
    if (!edited)
        return tl::unexpected(edited.error());
    EditedPlan after{{}, std::move(edited->from)};
    for (std::size_t i = 0; i < edited->structure.size(); ++i) {
        ProjectDevice &device = after.devices.emplace_back();
        if (const auto from = after.from[i])
            device = devicesOn(project, ring)[*from];
        device.bus = ring;
        device.participant = edited->structure[i];
    }
    return after;
}

RingPlace ringPlace(const KindData &where)
{
    const auto *place = where.as<RingPlace>();
    return place ? *place : RingPlace();
}

std::optional<RingPlace> movedIn(const RingStructure &ring, std::size_t device)
{
    const RingTree tree = ringTree(ring);
    const std::size_t row = tree.rowOf(device);
    if (row == 0 || tree.nodes[device].isLocal)
        return std::nullopt;
    const std::size_t before = tree.busOf(device)[row - 1];
    const RingTree::Node &terminal = tree.nodes[before];
    const bool isLocal = prefersLocalBus(ring[device]);
    return RingPlace{.terminal = before,
                     .onLocalBus = isLocal,
                     .row = isLocal ? terminal.localBus.size() : terminal.branch.size()};
}

std::optional<RingPlace> stepOf(const RingStructure &ring, std::size_t device, PlanStep step)
{
    RingPlace place = placeOf(ring, device);
    switch (step) {
    case PlanStep::up:
        if (place.row == 0)
            return std::nullopt;
        --place.row;
        return place;
    case PlanStep::down:
        place.row += 2; // after the neighbour: the row counts the device where it is now
        return place;
    case PlanStep::in:
        return movedIn(ring, device);
    case PlanStep::out:
    case PlanStep::changeBus:
        break;
    }
    if (!place.terminal)
        return std::nullopt;
    if (step == PlanStep::out) {
        RingPlace behind = placeOf(ring, *place.terminal);
        ++behind.row;
        return behind;
    }
    place.onLocalBus = !place.onLocalBus;
    place.row = place.onLocalBus ? ringTree(ring).nodes[*place.terminal].localBus.size() : 0;
    return place;
}

} // namespace

std::vector<Participant> RingPlanRules::offered(const Catalog &catalog) const
{
    std::vector<Participant> offered{deviceOf(busTerminalIdCode)};
    for (const DeviceDescription &device : catalog.devices()) {
        if (!device.hasWords())
            continue; // no bus
        RingDevice participant = deviceOf(device.deviceCode);
        participant.inWords = device.inWords;
        participant.outWords = device.outWords;
        participant.deviceKey = device.isGeneric() ? QString() : device.key;
        offered.emplace_back(participant);
    }
    return offered;
}

std::optional<Participant> RingPlanRules::coded(unsigned idCode, unsigned lengthCode) const
{
    return deviceOf(lengthCode << 8 | idCode);
}

std::vector<PlanTarget> RingPlanRules::targets(const Project &project, BusId bus,
                                               std::optional<std::size_t> chosen,
                                               std::optional<NodeId> /*connected*/) const
{
    const RingStructure ring = structureOf(project, bus);
    if (!chosen)
        return {
            {tr("At the end"), KindData(RingPlace{.terminal = {}, .onLocalBus = false, .row = ring.size()})}};
    const QString number = ring[*chosen].number.toString();
    const RingPlace before = placeOf(ring, *chosen);
    RingPlace behind = before;
    ++behind.row;
    std::vector<PlanTarget> targets{{tr("Behind %1").arg(number), KindData(behind)},
                                    {tr("Before %1").arg(number), KindData(before)}};
    if (ring[*chosen].idCode() != busTerminalIdCode)
        return targets;
    const RingTree tree = ringTree(ring);
    const RingTree::Node &terminal = tree.nodes[*chosen];
    targets.push_back(
        {tr("On the local bus of %1").arg(number),
         KindData(RingPlace{.terminal = chosen, .onLocalBus = true, .row = terminal.localBus.size()})});
    targets.push_back(
        {tr("In the branch of %1").arg(number),
         KindData(RingPlace{.terminal = chosen, .onLocalBus = false, .row = terminal.branch.size()})});
    return targets;
}

// A local-bus device put behind a bus terminal belongs on that terminal's local bus, which is the third
// target.
std::size_t RingPlanRules::preferred(const std::vector<PlanTarget> &targets, const Participant &device,
                                     std::size_t target) const
{
    constexpr std::size_t ownLocalBus = 2;
    if (targets.size() <= ownLocalBus)
        return target;
    if (prefersLocalBus(ringDevice(device)))
        return ownLocalBus;
    return target == ownLocalBus ? 0 : target;
}

Result<EditedPlan> RingPlanRules::insert(const Project &project, BusId ring, const Participant &device,
                                         const KindData &where) const
{
    return asPlan(project, ring,
                  insertDevice(structureOf(project, ring), ringDevice(device), ringPlace(where)));
}

Result<EditedPlan> RingPlanRules::remove(const Project &project, BusId ring,
                                         std::span<const std::size_t> devices) const
{
    return asPlan(project, ring, removeDevices(structureOf(project, ring), devices));
}

Result<EditedPlan> RingPlanRules::change(const Project &project, BusId ring, std::size_t device,
                                         const Participant &to) const
{
    const RingStructure structure = structureOf(project, ring);
    const RingDevice &before = structure[device];
    auto after = asPlan(project, ring, changeDevice(structure, device, ringDevice(to)));
    if (after && !(isSameKind(before, ringDevice(to)) && before.deviceKey == to.deviceKey))
        becomeAnother(after->devices[device]);
    return after;
}

Result<EditedPlan> RingPlanRules::move(const Project &project, BusId ring,
                                       std::span<const std::size_t> devices, const KindData &where) const
{
    return asPlan(project, ring, moveDevices(structureOf(project, ring), devices, ringPlace(where)));
}

std::optional<KindData> RingPlanRules::stepped(const Project &project, BusId ring, std::size_t device,
                                               PlanStep step) const
{
    const auto place = stepOf(structureOf(project, ring), device, step);
    return place ? std::optional(KindData(*place)) : std::nullopt;
}

std::optional<KindData> RingPlanRules::dropped(const Project &project, BusId bus, std::size_t device,
                                               std::optional<std::size_t> parent, int row) const
{
    const RingStructure ring = structureOf(project, bus);
    const RingTree tree = ringTree(ring);
    const auto at = static_cast<std::size_t>(row);
    if (!parent)
        return KindData(
            RingPlace{.terminal = {}, .onLocalBus = false, .row = row < 0 ? tree.mainLine.size() : at});
    const RingTree::Node &terminal = tree.nodes[*parent];
    const std::size_t localDevices = terminal.localBus.size();
    const bool isLocal = prefersLocalBus(ring[device]);
    RingPlace place{.terminal = parent, .onLocalBus = isLocal, .row = localDevices + terminal.branch.size()};
    if (row >= 0) {
        place.onLocalBus = at < localDevices || (at == localDevices && isLocal);
        place.row = place.onLocalBus ? at : at - localDevices;
    }
    return KindData(place);
}

Comparison RingPlanRules::compare(const Project &project, BusId ring, const ConnectedBus &connected) const
{
    return compareRings(structureOf(project, ring), ringStructure(connected.devices));
}

QString RingPlanRules::comparisonText(const ComparisonLine &line, const Project &project, BusId ring,
                                      const ConnectedBus &connected, const Catalog &catalog) const
{
    return codewheel::comparisonText(line, structureOf(project, ring), ringStructure(connected.devices),
                                     catalog);
}

std::map<NodeId, Refusal> RingPlanRules::uncertain(const Project &project, BusId ring,
                                                   const ConnectedBus &connected,
                                                   const Catalog &catalog) const
{
    return strangersInRing(structureOf(project, ring), ringStructure(connected.devices), catalog);
}

EditedPlan RingPlanRules::takenOver(const Project &project, BusId ring, const ConnectedBus &connected,
                                    const Comparison &comparison, std::span<const std::size_t> lines) const
{
    const Project after =
        codewheel::takenOver(project, ringStructure(connected.devices), comparison, lines, ring);
    const Devices devices = devicesOn(after, ring);
    EditedPlan plan{{devices.begin(), devices.end()}, {}};
    for (const TakenDevice &device : takeOver(comparison, lines))
        plan.from.push_back(device.own);
    return plan;
}

} // namespace codewheel
