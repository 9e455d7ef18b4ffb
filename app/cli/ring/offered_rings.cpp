// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ring/offered_rings.h"

#include "cli/texts.h"
#include "encoder/bus_names.h"
#include "project/ring_plan.h"
#include "simulator/fault_plan_file.h"
#include "simulator/planned_ring.h"

namespace codewheel {
namespace {

constexpr int mostSeats = 64;
constexpr std::chrono::milliseconds busCycle{1};

OfferedRings::Ring offered(const Call &call, const QString &name, TrainingBus bus)
{
    return {name, makeTrainingSession(call.catalog, QDateTime::currentDateTime(), std::move(bus))};
}

Checked<std::vector<const PlannedBus *>> simulatedRings(const Project &project)
{
    std::vector<const PlannedBus *> rings;
    for (const PlannedBus &bus : project.buses)
        if (bus.kind == QLatin1String(interbusKind) &&
            ringPlan(project, bus.id).link.kind == ProjectLink().kind && !devicesOn(project, bus.id).empty())
            rings.push_back(&bus);
    if (rings.empty())
        return badInput(QStringLiteral("nothingToServe"),
                        CommandLine::tr("The project has no ring with devices whose link is the training "
                                        "bus."));
    return rings;
}

Checked<void> checkSeats(int seats, std::size_t rings)
{
    if (seats == 0 || rings == 1)
        return {};
    return badInput(QStringLiteral("seatsOfSeveralRings"),
                    CommandLine::tr("The project has %1 rings, each a unit of its own. Leave --seats out."),
                    {static_cast<std::int64_t>(rings)});
}

Checked<void> startFaults(const Call &call, TrainingControls &controls)
{
    const auto file = call.arguments.value("--fault-plan");
    if (!file)
        return {};
    auto plan = loadFaultPlan(*file, controls.places());
    if (!plan)
        return tl::unexpected(complaintAbout(plan.error()));
    controls.startFaultPlan(*std::move(plan));
    return {};
}

// With several rings the plan would have to say whose places it means.
Checked<void> checkFaults(const Call &call, int seats, std::size_t rings)
{
    if (!call.arguments.has("--fault-plan") || seats > 0 || rings == 1)
        return {};
    return badInput(QStringLiteral("faultPlanOfSeveralRings"),
                    CommandLine::tr("A fault plan is for one ring, and the project has %1. Leave "
                                    "--fault-plan out."),
                    {static_cast<std::int64_t>(rings)});
}

} // namespace

Checked<OfferedRings> OfferedRings::of(const Call &call)
{
    const auto seats = call.arguments.number("--seats", 0, 1, mostSeats);
    if (!seats)
        return tl::unexpected(seats.error());
    std::vector<const PlannedBus *> planned;
    if (call.project != nullptr) {
        const auto rings = simulatedRings(*call.project);
        if (!rings)
            return tl::unexpected(rings.error());
        if (auto checked = checkSeats(*seats, rings->size()).and_then([&] {
                return checkFaults(call, *seats, rings->size());
            });
            !checked)
            return tl::unexpected(checked.error());
        planned = *rings;
    }
    OfferedRings all;
    const std::size_t count = std::max<std::size_t>({planned.size(), static_cast<std::size_t>(*seats), 1});
    for (std::size_t i = 0; i < count; ++i) {
        const PlannedBus *bus = planned.empty() ? nullptr : planned[planned.size() == 1 ? 0 : i];
        all.m_rings.push_back(offered(call, bus != nullptr ? bus->name : CommandLine::tr("Ring"),
                                      bus != nullptr ? makePlannedRing(*call.project, bus->id, call.catalog)
                                                     : makeTrainingBus(call.catalog)));
        if (auto started = startFaults(call, *all.m_rings.back().training.controls); !started)
            return tl::unexpected(started.error());
    }
    return all;
}

void OfferedRings::start()
{
    for (Ring &ring : m_rings) {
        ring.training.bus->offerTo(ring.guests);
        if (!ring.training.bus->open(EncoderBus::Start::operating)) // a simulated link always opens
            Q_UNREACHABLE();
        ring.training.bus->advance(1); // so that the first client finds it running
        ring.training.bus->startThread(busCycle);
    }
}

void OfferedRings::pump()
{
    for (Ring &ring : m_rings)
        ring.training.bus->pump();
}

ServedUnits OfferedRings::units(ServedUnits::Writing writing) const
{
    if (m_rings.size() == 1)
        return ServedUnits(m_rings.front().guests, writing);
    std::map<int, std::shared_ptr<RingGuests>> units;
    for (std::size_t i = 0; i < m_rings.size(); ++i)
        units[static_cast<int>(i) + 1] = m_rings[i].guests;
    return ServedUnits(units, writing);
}

} // namespace codewheel
