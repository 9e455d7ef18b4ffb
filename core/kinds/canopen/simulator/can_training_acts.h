// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/training_act.h"

namespace codewheel {

// What a trainer does to a simulated CAN bus and its encoders. The comment beside each lists what belongs to
// it.
enum class CanAct : std::uint8_t {
    shaftTurnedTo,     // raw position
    shaftTurnedByHand, // raw position
    shaftStopped,      //
    shaftTurns,        // rpm
    framesLost,        // of 1000; so for the next three
    framesDamaged,     //
    framesDoubled,     //
    framesLate,        //
    adapterAlone,      //
    adapterNotAlone,   //
    adapterBusOff,     //
    adapterUnplugged,  //
    adapterPluggedIn,  //
    loadByOthers,      // percent
    masterComes,       //
    masterGoes,        //
};

// What can be wrong with an encoder of the bus.
enum class NodeTrouble : std::uint8_t {
    powered, // that it is: everything is all right
    positionError,
    makersAlarm,
    lightReserve,
    cpuWatchdog,
    batteryLow,
    eepromBroken,
};

TrainingAct canAct(CanAct what, const std::vector<RefusalArgument> &its = {});
TrainingAct nodeTroubleAct(NodeTrouble trouble, bool isThere);
TrainingAct nodeQuirkAct(const char *key, bool isThere); // of a NamedQuirk

// In the user's language.
QString nodeTroubleName(NodeTrouble trouble); // "Position error"
QString nodeQuirkName(const char *key);       // "Starts by itself"

// Nothing: the act is none of a CAN bus.
std::optional<QString> canActText(const TrainingAct &act);

} // namespace codewheel
