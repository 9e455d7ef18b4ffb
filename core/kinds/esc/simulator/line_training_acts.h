// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/training_act.h"

namespace codewheel {

// What a trainer does to a simulated serial line and its encoders. The comment beside each lists what belongs
// to it.
enum class LineAct : std::uint8_t {
    shaftSpeed,       // rpm
    bytesLost,        // of 1000; so for the next three
    bytesWrong,       //
    bytesDoubled,     //
    bytesDelayed,     //
    echoOn,           //
    echoOff,          //
    allSilent,        //
    allAnswer,        //
    adapterUnplugged, //
    adapterPluggedIn, //
};

// What can be wrong with an encoder of the line.
enum class LineTrouble : std::uint8_t {
    powered, // that it is: everything is all right
    mute,
    batteryLimit,
    batteryFlat,
    temperatureExceeded,
    lightControl,
    positionError,
    vrHigh,
    stOpen,
};

TrainingAct lineAct(LineAct what, const std::vector<RefusalArgument> &its = {});
TrainingAct lineTroubleAct(LineTrouble trouble, bool isThere);
QString lineTroubleName(LineTrouble trouble); // "Battery flat", in the user's language

// Nothing: the act is none of a serial line.
std::optional<QString> lineActText(const TrainingAct &act);

} // namespace codewheel
