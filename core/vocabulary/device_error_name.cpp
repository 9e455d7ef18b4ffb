// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/device_error_name.h"

#include <QCoreApplication>

namespace codewheel {

QString deviceErrorName(RefusalCode meaning)
{
    switch (meaning.as<RefusalId>().value_or(RefusalId::otherDeviceError)) {
    case RefusalId::wrongParameterData:
        return QCoreApplication::translate("DeviceError", "wrong parameter data");
    case RefusalId::unknownParameterNumber:
        return QCoreApplication::translate("DeviceError", "unknown parameter number");
    case RefusalId::parametersLost:
        return QCoreApplication::translate("DeviceError", "parameters lost");
    case RefusalId::eepromStoreError:
        return QCoreApplication::translate("DeviceError", "parameters could not be stored");
    case RefusalId::batteryLow:
        return QCoreApplication::translate("DeviceError", "battery low");
    case RefusalId::codeDiscFault:
        return QCoreApplication::translate("DeviceError", "faulty value of the code disc");
    case RefusalId::manufacturerError:
        return QCoreApplication::translate("DeviceError", "an error of the manufacturer's own");
    case RefusalId::magnetOutOfRange:
        return QCoreApplication::translate("DeviceError", "magnet outside the measuring range");
    case RefusalId::noValidPosition:
        return QCoreApplication::translate("DeviceError", "no valid position");
    default:
        return QCoreApplication::translate("DeviceError", "not defined for this encoder");
    }
}

} // namespace codewheel
