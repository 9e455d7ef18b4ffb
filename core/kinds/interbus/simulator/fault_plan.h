// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/device_number.h"
#include "vocabulary/refusal.h"

#include <QString>

#include <chrono>
#include <vector>

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

// "Wire break before it", in the user's language; and as in the file: "wireBreak".
QString trainingFaultName(TrainingFault fault);
QString trainingFaultKey(TrainingFault fault);
// "3.0: Wire break before it"
QString trainingFaultText(TrainingFault fault, NodeId place, int value);

struct FaultStep
{
    std::chrono::milliseconds at{}; // since the plan was started, by the clock of the ring
    TrainingFault fault = TrainingFault::wireBreak;
    NodeId place;
    int value = 1; // 0: off, 1: on; CRC errors: per 1000 data cycles

    friend bool operator==(const FaultStep &, const FaultStep &) = default;
};

// A lesson or a test that runs the same way every time.
struct FaultPlan
{
    QString title;
    std::vector<FaultStep> steps; // by time; at least one

    friend bool operator==(const FaultPlan &, const FaultPlan &) = default;
};

// A place of the ring, and the faults that fit it.
struct TrainingPlace
{
    struct Standing
    {
        TrainingFault fault = TrainingFault::wireBreak;
        int value = 0; // as in FaultStep

        friend bool operator==(const Standing &, const Standing &) = default;
    };

    NodeId number;
    std::vector<Standing> faults; // in the order of TrainingFault
};

// The plan in `json` for a ring with these places, or the first thing wrong with it: faultPlanBroken. Its
// form is documented in docs/fault-plans.md. `name` is the file's, for the sentence.
Result<FaultPlan> faultPlanFromJson(const QByteArray &json, const QString &name,
                                    const std::vector<TrainingPlace> &ring);

} // namespace codewheel
