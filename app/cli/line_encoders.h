// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus_access.h"
#include "cli/line_access.h"
#include "cli/subcommand.h"
#include "project/project.h"

namespace codewheel {

// Whether PLACE means an encoder on the serial line of the call, or can mean no other since there is no ring.
bool isOnLine(const Call &call, const QString &place);

// The encoder at PLACE: its address as two hexadecimal digits. Refused where the command does not work with
// encoders on a serial line.
Checked<EncoderSession *> encoderOnLine(const Call &call, const QString &place);

// The device that --device names, an encoder for serial lines; else what the project has at that address.
Checked<QString> deviceOnLine(const Call &call, LineAddress address);

// Takes the encoder of the project into the polling, and waits until it shows where it stands. One that does
// not answer is no error: what is to be done with it will say so.
Checked<void> contactOnLine(const Call &call, const ProjectDevice &planned);

// Runs a job to its end, by the line's clock. Ctrl+C cancels it: what was sent is waited for, and read.
FinishedJob runOnLine(LineAccess &line, const AllowedJob &allowed);

} // namespace codewheel
