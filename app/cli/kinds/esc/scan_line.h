// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "kinds/esc/line/esc_line_scan.h"

#include <array>

namespace codewheel {

class EscLineAccess;

struct ScannedLine
{
    Answer answer;
    std::vector<FoundEncoder> encoders;
};

// Whether the options of the call say where to look.
Checked<void> checkScanOptions(const Call &call, const EscLineAccess &line);

// Searches for encoders on the line, as the options of the call say. Only reads. Ctrl+C ends it, keeping what
// was found so far.
Checked<ScannedLine> scanLine(const Call &call, EscLineAccess &line);

// Who answers at this address: empty if it is free.
Checked<std::optional<FoundEncoder>> whoIsAt(const Call &call, EscLineAccess &line, EscLineAddress address);

inline constexpr std::array scanLineOptions{
    Option{"--all-rates", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "serial line: at 19200, 9600 and 4800 Bd, not at that of the link alone")},
    Option{"--master", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "serial line: ask at the master address first, where one encoder is alone")},
    Option{"--first", "ADDRESS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "serial line: the first address asked (01)")},
    Option{"--last", "ADDRESS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "serial line: the last address asked (1F)")},
};

} // namespace codewheel
