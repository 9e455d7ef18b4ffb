// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/data_check.h"
#include "bus/fault.h"
#include "vocabulary/reading.h"

#include <QStringList>

namespace codewheel {

class EscLineSession;
struct SerialSettings;

// "/dev/ttyUSB0, 19 200 Bd, 8N2", or without a port "19 200 Bd, 8N2".
QString lineText(const QString &port, const SerialSettings &settings);

// Why there is no data of an encoder on the line, or, without a node, of the line itself.
DataChecks lineChecks(const EscLineSession &line, NodeId node, const std::vector<Participant> &planned);

// What is wrong with a serial line: its port, then its encoders, in the order of their addresses.
std::vector<Fault> lineFaults(const EscLineSession &line);

// The warnings that somebody has to do something about; the others only say how the shaft turns and where it
// is.
QStringList troubles(const Reading &reading);

} // namespace codewheel
