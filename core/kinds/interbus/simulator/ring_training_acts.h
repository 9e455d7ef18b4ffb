// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/training_fault.h"
#include "vocabulary/training_act.h"

namespace codewheel {

// What a trainer does to a device of a simulated ring. The comment beside each lists what belongs to it.
enum class RingAct : std::uint8_t {
    shaftTurnedTo,     // raw position
    shaftTurnedByHand, // raw position
    shaftStopped,      //
    shaftTurns,        // rpm
    magnetMovedTo,     // mm
    magnetMovedByHand, // mm
    magnetStopped,     //
    magnetMoves,       // mm/s
    magnetInRange,     //
    magnetOutOfRange,  //
    poweredOn,
    poweredOff,
    powerCycled,
    slowConfirmationOn,
    slowConfirmationOff,
    batteryIsLow,
    batteryIsFull,
    eepromIsWornOut,
    eepromIsInOrder,
    codeDiscIsFaulty,
    codeDiscIsInOrder,
    parametersAreLost,
};

TrainingAct ringAct(RingAct what, const std::vector<RefusalArgument> &its = {});
// A fault that begins or ends: of a fault plan, or of the ring.
TrainingAct faultAct(TrainingFault fault, NodeId place, int value);
// What was done to the ring of a seat of a class; an empty node: to the ring itself.
TrainingAct actAtSeat(int unit, NodeId node, const TrainingAct &act);

// Nothing: the act is none of a ring.
std::optional<QString> ringActText(const TrainingAct &act);

} // namespace codewheel
