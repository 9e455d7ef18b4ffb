// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/bus_plans.h"

#include "project/bus_kind.h"

#include <algorithm>

namespace codewheel {
namespace {

QString freeName(const Project &project, const QString &name)
{
    const auto isTaken = [&](const QString &its) {
        return std::ranges::find(project.buses, its, &PlannedBus::name) != project.buses.end();
    };
    QString free = name;
    for (int number = 2; isTaken(free); ++number)
        free = QStringLiteral("%1 %2").arg(name).arg(number);
    return free;
}

} // namespace

PlannedBus &planBus(Project &project, BusId bus, const BusKind &kind)
{
    if (PlannedBus *planned = findBus(project, bus))
        return *planned;
    const auto behind = std::ranges::upper_bound(project.buses, bus, {}, &PlannedBus::id);
    return *project.buses.insert(behind, {.id = bus,
                                          .kind = kind.key(),
                                          .name = freeName(project, kind.usualName()),
                                          .settings = kind.usual()});
}

} // namespace codewheel
