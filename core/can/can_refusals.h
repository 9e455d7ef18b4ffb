// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel {

// What only a link to a CAN bus refuses. The comment beside each lists its arguments; a name is that of the
// link ("can0", "/dev/ttyACM0").
enum class CanRefusalId : std::uint8_t {
    // badInput
    linkNotUnderstood, // the text given
    settingUnknown,    // the setting given
    baudRateWrong,     // the text given
    rateWrong,         // the text given, the rates there are
    rateMissing,       // the text given
    rateBySystem,      // interface
    logEmpty,          // file
    logHasNoTimes,     // file
    logHasNotThat,     // file, interface
    // link
    watchNotSure,     // name; and the command that makes a SocketCAN interface only listen
    rateRefused,      // name, rate
    openingRefused,   // name
    adapterSilent,    // name: nothing there answers
    openingNotKnown,  // name
    rateMayBe750,     // name: no reason not to open it
    onlyWatches,      // name
    busOff,           // name; and the command that restarts a SocketCAN interface
    interfaceMissing, // name
    interfaceDown,    // name, command
    interfaceLost,    // name
    notInKernel,      // name
    pluginMissing,    //
    onlyLogged,       // file
};
extern const RefusalFamily canRefusals;
constexpr const RefusalFamily &familyOf(CanRefusalId)
{
    return canRefusals;
}

} // namespace codewheel
