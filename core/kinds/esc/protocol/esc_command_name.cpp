// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_explain.h"
#include "vocabulary/enumeration_rows.h"

#include <QCoreApplication>

#include <array>

namespace codewheel::esc {
namespace {

struct CommandName
{
    Command command;
    const char *name;
};

constexpr std::array commandNames{
    CommandName{Command::operatingParameters, QT_TRANSLATE_NOOP("EscCommand", "operating parameters")},
    CommandName{Command::version, QT_TRANSLATE_NOOP("EscCommand", "version")},
    CommandName{Command::measuringRange, QT_TRANSLATE_NOOP("EscCommand", "total measuring range")},
    CommandName{Command::stepsPerTurn, QT_TRANSLATE_NOOP("EscCommand", "steps per revolution")},
    CommandName{Command::preset, QT_TRANSLATE_NOOP("EscCommand", "preset")},
    CommandName{Command::alarms, QT_TRANSLATE_NOOP("EscCommand", "alarms")},
    CommandName{Command::warnings, QT_TRANSLATE_NOOP("EscCommand", "warnings")},
    CommandName{Command::operatingTime, QT_TRANSLATE_NOOP("EscCommand", "operating time")},
    CommandName{Command::offset, QT_TRANSLATE_NOOP("EscCommand", "offset")},
    CommandName{Command::serialNumber, QT_TRANSLATE_NOOP("EscCommand", "serial number")},
    CommandName{Command::upperLimit, QT_TRANSLATE_NOOP("EscCommand", "upper limit switch")},
    CommandName{Command::lowerLimit, QT_TRANSLATE_NOOP("EscCommand", "lower limit switch")},
    CommandName{Command::scalingFactor, QT_TRANSLATE_NOOP("EscCommand", "scaling factor")},
    CommandName{Command::deviceCode, QT_TRANSLATE_NOOP("EscCommand", "device code")},
    CommandName{Command::revolutions, QT_TRANSLATE_NOOP("EscCommand", "number of revolutions")},
    CommandName{Command::position, QT_TRANSLATE_NOOP("EscCommand", "position")},
    CommandName{Command::writePreset, QT_TRANSLATE_NOOP("EscCommand", "preset")},
    CommandName{Command::writeStepsPerTurn, QT_TRANSLATE_NOOP("EscCommand", "steps per revolution")},
    CommandName{Command::writeRevolutions, QT_TRANSLATE_NOOP("EscCommand", "number of revolutions")},
    CommandName{Command::writeMeasuringRange, QT_TRANSLATE_NOOP("EscCommand", "total measuring range")},
    CommandName{Command::writeLowerLimit, QT_TRANSLATE_NOOP("EscCommand", "lower limit switch")},
    CommandName{Command::writeUpperLimit, QT_TRANSLATE_NOOP("EscCommand", "upper limit switch")},
    CommandName{Command::writeScalingFactor, QT_TRANSLATE_NOOP("EscCommand", "scaling factor")},
    CommandName{Command::writeDirection, QT_TRANSLATE_NOOP("EscCommand", "direction")},
    CommandName{Command::writeScaling, QT_TRANSLATE_NOOP("EscCommand", "scaling")},
    CommandName{Command::writeAddress, QT_TRANSLATE_NOOP("EscCommand", "device address")},
    CommandName{Command::writeBaudRate, QT_TRANSLATE_NOOP("EscCommand", "baud rate")},
};

static_assert(areInOrder(commandNames, &CommandName::command) &&
              commandNames.size() == static_cast<std::size_t>(Command::writeBaudRate) + 1);

} // namespace

QString commandName(Command command)
{
    return QCoreApplication::translate("EscCommand", commandNames.at(static_cast<std::size_t>(command)).name);
}

} // namespace codewheel::esc
