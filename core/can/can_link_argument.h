// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel {

// A link to a CAN bus as typed: "can:can0", "slcan:ttyACM0,rate=250000".
struct CanLinkArgument
{
    static constexpr int usualBaudRate = 115'200;

    bool isSerial = false;        // an SLCAN adapter, not an interface of the system
    QString where{};              // "can0"; "ttyACM0" or a path
    int rate = 0;                 // Bd, of the bus of an SLCAN adapter
    int baudRate = usualBaudRate; // of its port; those on USB take any

    QString text() const; // as it may be typed
    friend bool operator==(const CanLinkArgument &, const CanLinkArgument &) = default;
};

// Refused: linkNotUnderstood, settingUnknown, baudRateWrong, rateWrong, rateMissing, rateBySystem.
Result<CanLinkArgument> parseCanLink(const QString &typed);

// "10000, 20000, ..."
QString slcanRatesText();

} // namespace codewheel
