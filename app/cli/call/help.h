// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

namespace codewheel {

struct Subcommand;

// Its name and its arguments, as the user types them.
QString callOf(const Subcommand &command);
QString overallHelp();
QString helpOf(const Subcommand &command);
QString versionText(); // "codewheel-cli 0.1.0"

// The same for --json; texts in the user's language.
QJsonObject overallHelpJson();
QJsonObject helpJsonOf(const Subcommand &command);
QJsonObject versionJson();

} // namespace codewheel
