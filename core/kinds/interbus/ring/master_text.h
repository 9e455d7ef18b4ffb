// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/master_status.h"

#include <QString>

namespace codewheel {

// "RUN", the same in every view.
QString masterStateName(MasterState state);
// The fault and its place; "none", or a note that in READY no faults are looked for.
QString masterFaultText(const MasterStatus &status);

// By their codes (IBS SYS FW G4 UM).
enum class MasterService : std::uint16_t {
    readConfiguration = 0x030B,
    startDataTransfer = 0x0701,
    stopDataTransfer = 0x0702,
    createConfiguration = 0x0710,
    activateConfiguration = 0x0711,
    deactivateConfiguration = 0x0712,
    switchSegment = 0x0713,
    confirmDiagnostics = 0x0760,
    alarmStop = 0x1303,
    loadConfiguration = 0, // more than one service
};
// "creating the configuration (0710)", in the user's language.
QString masterServiceName(MasterService service);

// A bit of the diagnostic status register, 0..15: its name as in the master's manual ("PF"), and its meaning,
// in the user's language.
inline constexpr int diagnosticBits = 16;
QString diagnosticBitName(int bit);
QString diagnosticBitText(int bit);

} // namespace codewheel
