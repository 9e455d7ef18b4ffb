// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_settings.h"

namespace codewheel {

// Everything a CAN bus with CANopen is opened with. Kept per project.
struct CanopenSettings
{
    QString link;       // "can:can0", "slcan:ttyACM0"; empty: the simulated bus
    int rate = 125'000; // Bd

    bool isSimulated() const { return link.isEmpty(); }
    friend bool operator==(const CanopenSettings &, const CanopenSettings &) = default;
};

// To an interface or adapter; `rate` counts where the link does not say one.
CanopenSettings canopenSettings(const CanLinkArgument &link, int rate = CanopenSettings().rate);
// Refused like parseCanLink(): also the simulated bus has none.
Result<CanLinkArgument> canLinkOf(const CanopenSettings &settings);

} // namespace codewheel
