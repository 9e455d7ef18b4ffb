// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/enumeration_rows.h"
#include "esc/esc_explain.h"

#include <QCoreApplication>

#include <array>

namespace codewheel::esc {
namespace {

struct Row
{
    Command command;
    const char *name;
};

constexpr std::array rows{
    Row{Command::operatingParameters, QT_TRANSLATE_NOOP("EscCommand", "operating parameters")},
    Row{Command::version, QT_TRANSLATE_NOOP("EscCommand", "version")},
    Row{Command::measuringRange, QT_TRANSLATE_NOOP("EscCommand", "total measuring range")},
    Row{Command::stepsPerTurn, QT_TRANSLATE_NOOP("EscCommand", "steps per revolution")},
    Row{Command::preset, QT_TRANSLATE_NOOP("EscCommand", "preset")},
    Row{Command::alarms, QT_TRANSLATE_NOOP("EscCommand", "alarms")},
    Row{Command::warnings, QT_TRANSLATE_NOOP("EscCommand", "warnings")},
    Row{Command::operatingTime, QT_TRANSLATE_NOOP("EscCommand", "operating time")},
    Row{Command::offset, QT_TRANSLATE_NOOP("EscCommand", "offset")},
    Row{Command::serialNumber, QT_TRANSLATE_NOOP("EscCommand", "serial number")},
    Row{Command::upperLimit, QT_TRANSLATE_NOOP("EscCommand", "upper limit switch")},
    Row{Command::lowerLimit, QT_TRANSLATE_NOOP("EscCommand", "lower limit switch")},
    Row{Command::scalingFactor, QT_TRANSLATE_NOOP("EscCommand", "scaling factor")},
    Row{Command::deviceCode, QT_TRANSLATE_NOOP("EscCommand", "device code")},
    Row{Command::revolutions, QT_TRANSLATE_NOOP("EscCommand", "number of revolutions")},
    Row{Command::position, QT_TRANSLATE_NOOP("EscCommand", "position")},
    Row{Command::writePreset, QT_TRANSLATE_NOOP("EscCommand", "preset")},
    Row{Command::writeStepsPerTurn, QT_TRANSLATE_NOOP("EscCommand", "steps per revolution")},
    Row{Command::writeRevolutions, QT_TRANSLATE_NOOP("EscCommand", "number of revolutions")},
    Row{Command::writeMeasuringRange, QT_TRANSLATE_NOOP("EscCommand", "total measuring range")},
    Row{Command::writeLowerLimit, QT_TRANSLATE_NOOP("EscCommand", "lower limit switch")},
    Row{Command::writeUpperLimit, QT_TRANSLATE_NOOP("EscCommand", "upper limit switch")},
    Row{Command::writeScalingFactor, QT_TRANSLATE_NOOP("EscCommand", "scaling factor")},
    Row{Command::writeDirection, QT_TRANSLATE_NOOP("EscCommand", "direction")},
    Row{Command::writeScaling, QT_TRANSLATE_NOOP("EscCommand", "scaling")},
    Row{Command::writeAddress, QT_TRANSLATE_NOOP("EscCommand", "device address")},
    Row{Command::writeBaudRate, QT_TRANSLATE_NOOP("EscCommand", "baud rate")},
};

static_assert(areInOrder(rows, &Row::command) &&
              rows.size() == static_cast<std::size_t>(Command::writeBaudRate) + 1);

} // namespace

QString commandName(Command command)
{
    return QCoreApplication::translate("EscCommand", rows.at(static_cast<std::size_t>(command)).name);
}

} // namespace codewheel::esc
