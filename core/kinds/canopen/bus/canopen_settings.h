// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// Everything a CAN bus with CANopen is opened with. Kept per project.
struct CanopenSettings
{
    QString link;       // "can:can0", "slcan:ttyACM0"; empty: the simulated bus
    int rate = 125'000; // Bd

    friend bool operator==(const CanopenSettings &, const CanopenSettings &) = default;
};

} // namespace codewheel
