// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/bus_plans.h"

#include "project/bus_kind.h"

#include <algorithm>
#include <limits>

namespace codewheel {
namespace {

int behindTrainingBuses()
{
    int last = 0;
    for (const QString &kind : busKindKeys())
        last = std::max(last, busKind(kind)->trainingBus().value_or(BusId{0}).number);
    return last + 1;
}

// After all others; a file may have used up the largest number.
int firstToTry(const Project &project)
{
    int first = behindTrainingBuses();
    for (const PlannedBus &bus : project.buses)
        if (bus.id.number < std::numeric_limits<int>::max())
            first = std::max(first, bus.id.number + 1);
    return first;
}

} // namespace

QString freeName(const QString &name, const std::function<bool(const QString &)> &isTaken)
{
    QString free = name;
    for (int number = 2; isTaken(free); ++number)
        free = QStringLiteral("%1 %2").arg(name).arg(number);
    return free;
}

PlannedBus &planBus(Project &project, BusId bus, const BusKind &kind)
{
    if (PlannedBus *planned = findBus(project, bus))
        return *planned;
    const auto isTaken = [&](const QString &its) {
        return std::ranges::find(project.buses, its, &PlannedBus::name) != project.buses.end();
    };
    const auto behind = std::ranges::upper_bound(project.buses, bus, {}, &PlannedBus::id);
    return *project.buses.insert(behind, {.id = bus,
                                          .kind = kind.key(),
                                          .name = freeName(kind.nameOfNew(), isTaken),
                                          .settings = kind.usual()});
}

BusId freeNumber(const Project &project, const BusKind &kind, const std::function<bool(BusId)> &isFree)
{
    const auto canBe = [&](BusId bus) { return findBus(project, bus) == nullptr && isFree(bus); };
    if (const auto training = kind.trainingBus(); training && canBe(*training))
        return *training;
    BusId free{firstToTry(project)};
    while (!canBe(free))
        free = {free.number == std::numeric_limits<int>::max() ? behindTrainingBuses() : free.number + 1};
    return free;
}

void removeBus(Project &project, BusId bus)
{
    setDevicesOn(project, bus, {});
    std::erase_if(project.buses, [bus](const PlannedBus &its) { return its.id == bus; });
}

} // namespace codewheel
