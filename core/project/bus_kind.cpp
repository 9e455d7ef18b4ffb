// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/bus_kind.h"

#include "kinds/buses.h"
#include "project/plan_rules.h"
#include "replay/recorded_rows.h"

#include <algorithm>

namespace codewheel {
namespace {

using Kinds = std::vector<std::unique_ptr<const BusKind>>;

Kinds &kinds()
{
    static Kinds all = builtInBusKinds();
    return all;
}

} // namespace

const PlanRules &BusKind::planRules() const
{
    static const PlanRules none;
    return none;
}

std::unique_ptr<RecordedRows> BusKind::recordedRows(Profile /*profile*/) const
{
    return nullptr;
}

const BusKind *busKind(QStringView key)
{
    const auto found = std::ranges::find(kinds(), key, [](const auto &kind) { return kind->key(); });
    return found == kinds().end() ? nullptr : found->get();
}

bool plansTraining(const Project &project, BusId bus)
{
    const PlannedBus *planned = findBus(project, bus);
    const BusKind *kind = planned != nullptr ? busKind(planned->kind) : nullptr;
    return kind == nullptr || kind->isTraining(planned->settings);
}

QStringList busKindKeys()
{
    QStringList keys;
    for (const auto &kind : kinds())
        keys << kind->key();
    return keys;
}

void addBusKind(std::unique_ptr<const BusKind> kind)
{
    kinds().push_back(std::move(kind));
}

} // namespace codewheel
