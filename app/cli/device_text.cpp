// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/device_text.h"

#include "cli/texts.h"

namespace codewheel {

Checked<const DeviceDescription *> deviceNamed(const Catalog &catalog, const QString &key)
{
    if (const DeviceDescription *device = catalog.find(key))
        return device;
    QStringList keys;
    for (const DeviceDescription &device : catalog.devices())
        keys << device.key;
    return badInput(QStringLiteral("unknownDeviceName"),
                    CommandLine::tr("There is no device named \"%1\". The names are: %2."),
                    {key, keys.join(QStringLiteral(", "))});
}

} // namespace codewheel
