// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "project/project.h"

namespace codewheel {

// The device that --device names, an encoder for serial lines; otherwise what the project has at that place,
// otherwise the usual one: what is sent to both makes is the same.
Checked<QString> deviceOnLine(const Call &call, Place place);
QString usualDeviceOnLine();
QString deviceOf(const Call &call, const ProjectDevice *planned); // null: the usual one

// As far as the project tells: at the master address all encoders of a line would be addressed.
Checked<void> checkIsAlone(const Call &call, Place place);

} // namespace codewheel
