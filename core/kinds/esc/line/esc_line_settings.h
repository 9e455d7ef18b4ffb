// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_exchange.h"
#include "kinds/esc/protocol/esc_scaling.h"
#include "serial/serial_settings.h"

#include <QString>

namespace codewheel {

// Everything a serial line is opened with. Kept per project, shown by the settings form.
struct EscLineSettings
{
    static constexpr Instant shortestInterval{10'000}; // manual, terminal assignment, note 1

    QString port; // "/dev/ttyUSB0", or the path of a pty
    SerialSettings serial;
    esc::Timing timing;
    Instant pollInterval = shortestInterval; // between position requests of one encoder
    int fractionBits = esc::defaultFractionBits;
    double topSpeed = 6'000; // 1/min; a position that jumps further is suspect

    friend bool operator==(const EscLineSettings &, const EscLineSettings &) = default;
};

} // namespace codewheel
