// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/complaint.h"
#include "drivers/esc_settings.h"
#include "esc/esc_explain.h"
#include "project/line_plan.h"

#include <QString>

namespace codewheel {

// Before the port in --link, and before the address of an encoder on a line.
inline constexpr QLatin1String linePrefix(LineAddress::prefix.data(), qsizetype{LineAddress::prefix.size()});

// The serial line that --link names.
struct LineLink
{
    LineWish wish{};                  // its port: a name or a path; empty: the simulated line
    bool swapWarningBytes = false;    // of all its encoders
    std::set<LineAddress> swapping{}; // of these, as the project says
    bool asksForFractionBits = false; // of the scaling factor, from the encoder
    LineAdapter adapter{};            // that the port belongs to; nothing: whichever is there

    bool isSimulated() const { return wish.port.isEmpty(); }
    EscSettings driver() const;
    esc::ExplainOptions explainOptions() const;
};

// What --link names.
struct LinkWish
{
    bool hasRing = true; // the training bus, which has the simulated line beside its ring
    LineLink line{};
};

// "training", "esc:ttyUSB0,baud=9600", "esc:/dev/pts/5", "esc:training"; "esc:project" is the line of the
// project, null where there is none.
Checked<LinkWish> linkMeant(const QString &text, const Project *project = nullptr);
// Whether it means something with a project only.
bool isLineOfProject(const QString &link);

// The settings of a line, for the help: "baud, format, ...".
QString lineSettingKeys();
// The serial ports of this computer in a sentence, or that it has none.
QString presentPortsText();

} // namespace codewheel
