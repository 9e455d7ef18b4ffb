// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/preset_storage.h"

namespace codewheel {

bool mayStorePreset(const DeviceDescription &device)
{
    return device.capabilities.presetIsStored || (device.isGeneric() && device.profile == Profile::k3);
}

} // namespace codewheel
