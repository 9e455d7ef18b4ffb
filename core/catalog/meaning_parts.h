// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

#include <QStringList>

namespace codewheel {

// The parts of a meaning's sentence (encoder/meaning_text.h) as this device calls them.
QStringList meaningParts(const DeviceDescription &device, const Meaning &meaning);

} // namespace codewheel
