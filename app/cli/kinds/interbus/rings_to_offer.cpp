// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/rings_to_offer.h"

#include "cli/call/texts.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/simulator/fault_plan.h"
#include "kinds/interbus/simulator/planned_ring.h"
#include "vocabulary/bus_names.h"

namespace codewheel {
namespace {

constexpr int mostSeats = 64;

Checked<std::vector<const PlannedBus *>> simulatedRings(const Project &project)
{
    std::vector<const PlannedBus *> rings;
    for (const PlannedBus &bus : project.buses)
        if (bus.kind == QLatin1String(interbusKind) &&
            ringPlan(project, bus.id).link.kind == ProjectLink().kind && !devicesOn(project, bus.id).empty())
            rings.push_back(&bus);
    if (rings.empty())
        return badInput("nothingToServe",
                        CommandLine::tr("The project has no ring with devices whose link is the training "
                                        "bus."));
    return rings;
}

Checked<void> checkSeats(int seats, std::size_t rings)
{
    if (seats == 0 || rings == 1)
        return {};
    return badInput("seatsOfSeveralRings",
                    CommandLine::tr("The project has %1 rings, each a unit of its own. Leave --seats out."),
                    {static_cast<std::int64_t>(rings)});
}

Checked<void> startFaults(const QString &file, TrainingControls &controls)
{
    auto plan = loadFaultPlan(file, controls.places());
    if (!plan)
        return tl::unexpected(complaintAbout(plan.error()));
    controls.startFaultPlan(*std::move(plan));
    return {};
}

// Whether the fault plan is for this ring: for that of each seat; of several of a project for the one that
// --fault-bus names.
bool isRingOfFaults(const Call &call, const OfferedRings::Ring &ring, bool isOneOfSeveral)
{
    return !isOneOfSeveral || call.arguments.value("--fault-bus") == ring.name;
}

Checked<void> startFaults(const Call &call, const std::vector<OfferedRings::Ring> &rings, bool areDifferent)
{
    const auto file = call.arguments.value("--fault-plan");
    bool isStarted = !file;
    for (const OfferedRings::Ring &ring : rings) {
        if (!file || !isRingOfFaults(call, ring, areDifferent))
            continue;
        if (auto started = startFaults(*file, *ring.training.controls); !started)
            return started;
        isStarted = true;
    }
    if (isStarted)
        return {};
    return badInput("faultPlanOfSeveralRings",
                    CommandLine::tr("A fault plan is for one ring. Name it with --fault-bus: %1."),
                    {listed(rings, &OfferedRings::Ring::name)});
}

} // namespace

Checked<OfferedRings> ringsToOffer(const Call &call)
{
    const auto seats = call.arguments.number("--seats", 0, 1, mostSeats);
    if (!seats)
        return tl::unexpected(seats.error());
    std::vector<const PlannedBus *> planned;
    if (call.project != nullptr) {
        const auto rings = simulatedRings(*call.project);
        if (!rings)
            return tl::unexpected(rings.error());
        if (auto checked = checkSeats(*seats, rings->size()); !checked)
            return tl::unexpected(checked.error());
        planned = *rings;
    }
    OfferedRings all;
    const std::size_t count = std::max<std::size_t>({planned.size(), static_cast<std::size_t>(*seats), 1});
    for (std::size_t i = 0; i < count; ++i) {
        const PlannedBus *bus = planned.empty() ? nullptr : planned[planned.size() == 1 ? 0 : i];
        all.add(bus != nullptr ? bus->name : CommandLine::tr("Ring"),
                makeTrainingSession(call.catalog, QDateTime::currentDateTime(),
                                    bus != nullptr ? makePlannedRing(*call.project, bus->id, call.catalog)
                                                   : makeTrainingBus(call.catalog)));
    }
    if (auto started = startFaults(call, all.rings(), planned.size() > 1); !started)
        return tl::unexpected(started.error());
    return all;
}

ServedUnits unitsOf(const OfferedRings &rings, ServedUnits::Writing writing)
{
    if (rings.rings().size() == 1)
        return ServedUnits(rings.rings().front().guests, writing);
    return rings.units(writing);
}

} // namespace codewheel
