// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <QString>

namespace codewheel {

class RingSession;

// What the ring's master says, line by line; and for programs (docs/command-line.md), null if the link
// reaches no master.
QString masterLines(const RingSession &bus);
QJsonValue masterJson(const RingSession &bus);

} // namespace codewheel
