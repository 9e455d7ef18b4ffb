// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "kinds/canopen/eds/device_file.h"

namespace codewheel {

// Makes a description of the device in the user's folder, by which it is known from then on.
Checked<Answer> importDeviceFile(const Call &call, const QString &path, const canopen::DeviceFile &file);

} // namespace codewheel
