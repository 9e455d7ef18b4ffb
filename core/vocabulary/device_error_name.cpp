// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

constexpr auto deviceErrorNames = std::to_array<TextOf<RefusalId>>({
    {RefusalId::wrongParameterData, QT_TRANSLATE_NOOP("DeviceError", "wrong parameter data")},
    {RefusalId::unknownParameterNumber, QT_TRANSLATE_NOOP("DeviceError", "unknown parameter number")},
    {RefusalId::parametersLost, QT_TRANSLATE_NOOP("DeviceError", "parameters lost")},
    {RefusalId::eepromStoreError, QT_TRANSLATE_NOOP("DeviceError", "parameters could not be stored")},
    {RefusalId::batteryLow, QT_TRANSLATE_NOOP("DeviceError", "battery low")},
    {RefusalId::codeDiscFault, QT_TRANSLATE_NOOP("DeviceError", "faulty value of the code disc")},
    {RefusalId::manufacturerError, QT_TRANSLATE_NOOP("DeviceError", "an error of the manufacturer's own")},
    {RefusalId::magnetOutOfRange, QT_TRANSLATE_NOOP("DeviceError", "magnet outside the measuring range")},
    {RefusalId::noValidPosition, QT_TRANSLATE_NOOP("DeviceError", "no valid position")},
});

} // namespace

QString deviceErrorName(RefusalCode meaning)
{
    const RefusalId id = meaning.as<RefusalId>().value_or(RefusalId::otherDeviceError);
    return QCoreApplication::translate(
        "DeviceError",
        textFor(deviceErrorNames, id, QT_TRANSLATE_NOOP("DeviceError", "not defined for this encoder")));
}

} // namespace codewheel
