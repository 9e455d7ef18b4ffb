// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/link_kind.h"
#include "kinds/esc/driver/esc_settings.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/protocol/esc_explain.h"

#include <QString>

namespace codewheel {

// The serial line that --link names.
struct EscLineLink
{
    EscLineSettings settings{};          // its port: a name or a path; empty: the simulated line
    bool swapWarningBytes = false;       // for all its encoders
    std::set<EscLineAddress> swapping{}; // for these, as the project says
    bool asksForFractionBits = false;    // of the scaling factor, from the encoder
    EscLineAdapter adapter{};            // that the port belongs to; empty: whichever is there
    std::optional<Complaint> whyNot{};   // if it cannot be opened
    QString alsoOf{};                    // another bus of the project that has the same port

    bool isSimulated() const { return settings.port.isEmpty(); }
    EscSettings driver() const;
    esc::ExplainOptions explainOptions() const;
};

// What can be set behind the port: "baud", "format", ...
QStringList lineSettingKeys();

// "esc:ttyUSB0,baud=9600", "esc:/dev/pts/5", "esc:training"; for encoders on this line of the project (null:
// none) what the project says of them applies.
Checked<EscLineLink> lineMeant(const LinkText &text, const Project *project = nullptr,
                               BusId line = firstLine);
// A line of the project; these settings ("baud=9600") take precedence over its own. If it has no port, the
// link says so when it is opened, and the other buses can still be used.
Checked<EscLineLink> lineOf(const Project &project, BusId line, const QStringList &settings = {});

} // namespace codewheel
