// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_explain.h"
#include "vocabulary/enumeration_rows.h"

#include <QCoreApplication>

#include <array>

namespace codewheel::esc {
namespace {

constexpr auto commandNames = std::to_array<TextOf<Command>>({
    {Command::operatingParameters, QT_TRANSLATE_NOOP("EscCommand", "operating parameters")},
    {Command::version, QT_TRANSLATE_NOOP("EscCommand", "version")},
    {Command::measuringRange, QT_TRANSLATE_NOOP("EscCommand", "total measuring range")},
    {Command::stepsPerTurn, QT_TRANSLATE_NOOP("EscCommand", "steps per revolution")},
    {Command::preset, QT_TRANSLATE_NOOP("EscCommand", "preset")},
    {Command::alarms, QT_TRANSLATE_NOOP("EscCommand", "alarms")},
    {Command::warnings, QT_TRANSLATE_NOOP("EscCommand", "warnings")},
    {Command::operatingTime, QT_TRANSLATE_NOOP("EscCommand", "operating time")},
    {Command::offset, QT_TRANSLATE_NOOP("EscCommand", "offset")},
    {Command::serialNumber, QT_TRANSLATE_NOOP("EscCommand", "serial number")},
    {Command::upperLimit, QT_TRANSLATE_NOOP("EscCommand", "upper limit switch")},
    {Command::lowerLimit, QT_TRANSLATE_NOOP("EscCommand", "lower limit switch")},
    {Command::scalingFactor, QT_TRANSLATE_NOOP("EscCommand", "scaling factor")},
    {Command::deviceCode, QT_TRANSLATE_NOOP("EscCommand", "device code")},
    {Command::revolutions, QT_TRANSLATE_NOOP("EscCommand", "number of revolutions")},
    {Command::position, QT_TRANSLATE_NOOP("EscCommand", "position")},
    {Command::writePreset, QT_TRANSLATE_NOOP("EscCommand", "preset")},
    {Command::writeStepsPerTurn, QT_TRANSLATE_NOOP("EscCommand", "steps per revolution")},
    {Command::writeRevolutions, QT_TRANSLATE_NOOP("EscCommand", "number of revolutions")},
    {Command::writeMeasuringRange, QT_TRANSLATE_NOOP("EscCommand", "total measuring range")},
    {Command::writeLowerLimit, QT_TRANSLATE_NOOP("EscCommand", "lower limit switch")},
    {Command::writeUpperLimit, QT_TRANSLATE_NOOP("EscCommand", "upper limit switch")},
    {Command::writeScalingFactor, QT_TRANSLATE_NOOP("EscCommand", "scaling factor")},
    {Command::writeDirection, QT_TRANSLATE_NOOP("EscCommand", "direction")},
    {Command::writeScaling, QT_TRANSLATE_NOOP("EscCommand", "scaling")},
    {Command::writeAddress, QT_TRANSLATE_NOOP("EscCommand", "device address")},
    {Command::writeBaudRate, QT_TRANSLATE_NOOP("EscCommand", "baud rate")},
});

static_assert(areInOrder(commandNames, &TextOf<Command>::id, Command::writeBaudRate));

} // namespace

QString commandName(Command command)
{
    return QCoreApplication::translate("EscCommand", rowOf(commandNames, command).text);
}

} // namespace codewheel::esc
