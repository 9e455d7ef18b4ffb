// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/participant.h"

#include "catalog/device_description.h"

#include <QCoreApplication>

namespace codewheel {

QString participantName(const DeviceDescription *description)
{
    return description ? description->fullName()
                       : QCoreApplication::translate("Participant", "device not known");
}

} // namespace codewheel
