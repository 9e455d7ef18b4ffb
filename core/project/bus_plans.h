// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <functional>

namespace codewheel {

class BusKind;

inline constexpr std::size_t mostBuses = 100; // of a project

// This one, or with a number after it.
QString freeName(const QString &name, const std::function<bool(const QString &)> &isTaken);
// The bus with this number; without one a new bus of this kind, with a name that no other has.
PlannedBus &planBus(Project &project, BusId bus, const BusKind &kind);

// The number for a new bus. Those of the training buses are only given to buses of their kind. isFree: what
// else a number has to satisfy, besides that no bus is planned with it.
BusId freeNumber(
    const Project &project, const BusKind &kind,
    const std::function<bool(BusId)> &isFree = [](BusId) { return true; });
// Removes the bus and its devices from the plan.
void removeBus(Project &project, BusId bus);

} // namespace codewheel
