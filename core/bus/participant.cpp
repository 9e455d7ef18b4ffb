// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/participant.h"

#include "catalog/device_description.h"

#include <QCoreApplication>

namespace codewheel {

QString participantName(const Participant &participant, const DeviceDescription *description)
{
    if (description)
        return description->fullName();
    if (participant.idCode == busTerminalIdCode)
        return QCoreApplication::translate("Participant", "bus terminal");
    return QCoreApplication::translate("Participant", "device not known");
}

} // namespace codewheel
