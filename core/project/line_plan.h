// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc_line/line_settings.h"
#include "project/project.h"

namespace codewheel {

class BusKind;

// The USB adapter that a serial line is connected by, as far as it tells: by its serial number, else by its
// place on USB, it is known again after it was plugged in elsewhere. 0 or empty: not told.
struct LineAdapter
{
    int vendor = 0;
    int product = 0;
    QString serialNumber;
    QString usbPath; // "1-2.4:1.0"

    friend bool operator==(const LineAdapter &, const LineAdapter &) = default;
};

// A serial line, as it is planned.
struct LinePlan
{
    LineSettings settings; // the file keeps of its timing: time-out, retries, and the quiet after a write
    LineAdapter adapter;

    friend bool operator==(const LinePlan &, const LinePlan &) = default;
};
inline constexpr char escKind[] = "esc";

// Null: the project has no serial line of this number.
const LinePlan *linePlan(const Project &project, BusId line);
// Plans the line, if the project has none yet.
void setLinePlan(Project &project, BusId line, LinePlan plan);

// Serial lines, for the list of kinds (bus_kind.cpp).
std::unique_ptr<const BusKind> makeLineKind();

} // namespace codewheel
