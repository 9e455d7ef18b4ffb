// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

struct Subcommand;

QString overallHelp();
QString helpOf(const Subcommand &command);
QString versionText(); // "codewheel-cli 0.1.0"

} // namespace codewheel
