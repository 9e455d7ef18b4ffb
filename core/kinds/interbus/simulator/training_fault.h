// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace codewheel {

// What can happen to a simulated ring and its devices.
enum class TrainingFault : std::uint8_t {
    wireBreak, // before the device
    crcErrors, // in its segment: faulty data cycles per 1000
    noSupply,
    wrongDevice,
    peripheralFault,
    powerOff,         // of the encoder; the ring keeps running
    slowConfirmation, // takes 50 times as long
    eepromWornOut,    // error 13 when run is to store
    parametersLost,   // error 3; an event, not a state
    batteryLow,       // shows at the next power-up
    codeDiscFault,    // error 15, spontaneously
    camOutOfRange,    // 98000004, spontaneously
    magnetLost,       // outside the measuring range
};
inline constexpr int trainingFaults = static_cast<int>(TrainingFault::magnetLost) + 1;
inline constexpr int mostCrcErrors = 100; // per 1000

// "Wire break before it", in the user's language; and as in files and messages: "wireBreak".
QString trainingFaultName(TrainingFault fault);
QString trainingFaultKey(TrainingFault fault);
std::optional<TrainingFault> trainingFaultFromKey(const QString &key);
// "3.0: Wire break before it". The value is that of FaultStep.
QString trainingFaultText(TrainingFault fault, const QString &place, std::int64_t value);
QString trainingFaultText(TrainingFault fault, NodeId place, int value);

} // namespace codewheel
