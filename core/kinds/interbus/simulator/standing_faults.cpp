// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/fault_plan.h"

#include <QStringList>

#include <algorithm>

namespace codewheel {
namespace {

bool stands(const TrainingPlace &place, TrainingFault fault)
{
    return std::ranges::any_of(place.faults, [fault](const TrainingPlace::Standing &its) {
        return its.fault == fault && its.value > 0;
    });
}

bool goesWithoutSaying(const TrainingPlace &place, TrainingFault fault)
{
    return fault == TrainingFault::powerOff &&
           (stands(place, TrainingFault::noSupply) || stands(place, TrainingFault::wrongDevice));
}

} // namespace

QString standingFaultsText(const std::vector<TrainingPlace> &ring)
{
    QStringList texts;
    for (const TrainingPlace &place : ring)
        for (const auto &[fault, value] : place.faults)
            if (value > 0 && !goesWithoutSaying(place, fault))
                texts << trainingFaultText(fault, place.number, value);
    return texts.join(QStringLiteral(", "));
}

} // namespace codewheel
