// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_settings.h"
#include "project/project.h"

namespace codewheel {

class BusKind;

// The USB adapter of a serial line, as far as it identifies itself: by its serial number, otherwise by its
// place on USB, it is recognised after it was plugged in elsewhere. 0 or empty: not known.
struct EscLineAdapter
{
    int vendor = 0;
    int product = 0;
    QString serialNumber;
    QString usbPath; // "1-2.4:1.0"

    friend bool operator==(const EscLineAdapter &, const EscLineAdapter &) = default;
};

// What is peculiar to an encoder.
struct EscEncoderSettings
{
    bool swapsWarningBytes = false; // its warnings come with the low byte first

    friend bool operator==(const EscEncoderSettings &, const EscEncoderSettings &) = default;
};

// A serial line as planned; its encoders have EscEncoderSettings.
struct EscLinePlan
{
    EscLineSettings settings; // of its timing, the file keeps time-out, retries, and the quiet after a write
    EscLineAdapter adapter;

    friend bool operator==(const EscLinePlan &, const EscLinePlan &) = default;
};
inline constexpr char escKind[] = "esc";

// Null: the project has no serial line with this number.
const EscLinePlan *linePlan(const Project &project, BusId line);
// Plans the line if the project does not have it yet.
void setLinePlan(Project &project, BusId line, EscLinePlan plan);

// Serial lines, for the list of kinds (bus_kind.cpp).
std::unique_ptr<const BusKind> makeLineKind();

} // namespace codewheel
