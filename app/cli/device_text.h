// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "cli/complaint.h"

namespace codewheel {

// The device of this key, or the keys there are.
Checked<const DeviceDescription *> deviceNamed(const Catalog &catalog, const QString &key);

} // namespace codewheel
