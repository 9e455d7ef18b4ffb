// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/device_file.h"

#include <QByteArray>

#include <tl/expected.hpp>

namespace codewheel::canopen {

// The bytes of an EDS or DCF, of whatever maker and tool. What is in it otherwise than CiA 306 has it gets a
// note, and the rest is read; refused is a file without objects, and one with more than any encoder has.
tl::expected<DeviceFile, EdsNote> readDeviceFile(const QByteArray &bytes);

} // namespace codewheel::canopen
