// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/preset_storage.h"

#include "catalog/protocol_rules.h"

namespace codewheel {

bool mayStorePreset(const DeviceDescription &device)
{
    return device.capabilities.presetIsStored ||
           (device.isGeneric() && protocolRules(device.profile).dependsOnMake());
}

} // namespace codewheel
