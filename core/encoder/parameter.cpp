// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/parameter.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

struct Row
{
    Parameter parameter;
    const char *key;
    const char *name;
};

constexpr std::array rows{
    Row{Parameter::steps, "steps", QT_TRANSLATE_NOOP("Parameter", "Steps")},
    Row{Parameter::revolutions, "revolutions", QT_TRANSLATE_NOOP("Parameter", "Revolutions")},
    Row{Parameter::direction, "direction", QT_TRANSLATE_NOOP("Parameter", "Direction")},
    Row{Parameter::coding, "coding", QT_TRANSLATE_NOOP("Parameter", "Coding")},
    Row{Parameter::preset, "preset", QT_TRANSLATE_NOOP("Parameter", "Preset")},
    Row{Parameter::zeroOffset, "zero-offset", QT_TRANSLATE_NOOP("Parameter", "Zero offset")},
    Row{Parameter::offset, "offset", QT_TRANSLATE_NOOP("Parameter", "Offset")},
    Row{Parameter::measuringRange, "measuring-range", QT_TRANSLATE_NOOP("Parameter", "Measuring range")},
    Row{Parameter::serialNumber, "serial-number", QT_TRANSLATE_NOOP("Parameter", "Serial number")},
    Row{Parameter::presetFlag, "preset-flag", QT_TRANSLATE_NOOP("Parameter", "Preset flag")},
    Row{Parameter::softwareVersion, "software-version", QT_TRANSLATE_NOOP("Parameter", "Software version")},
    Row{Parameter::operatingTime, "operating-time", QT_TRANSLATE_NOOP("Parameter", "Operating time")},
    Row{Parameter::startUpMode, "start-up-mode", QT_TRANSLATE_NOOP("Parameter", "Start-up mode")},
    Row{Parameter::multiTurnAndStepsMinusOne, "multi-turn-steps-minus-1",
        QT_TRANSLATE_NOOP("Parameter", "Multi-turn and steps minus 1")},
    Row{Parameter::temperature, "temperature", QT_TRANSLATE_NOOP("Parameter", "Temperature")},
};

constexpr auto parameters = [] {
    std::array<Parameter, rows.size()> all{};
    std::transform(rows.begin(), rows.end(), all.begin(), [](const Row &row) { return row.parameter; });
    return all;
}();

// rows stand in the order of the enumeration
constexpr bool rowsInOrder = [] {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (static_cast<std::size_t>(rows[i].parameter) != i)
            return false;
    return true;
}();
static_assert(rowsInOrder);

const Row &rowOf(Parameter parameter)
{
    return rows.at(static_cast<std::size_t>(parameter));
}

} // namespace

QString parameterKey(Parameter parameter)
{
    return QString::fromLatin1(rowOf(parameter).key);
}

std::optional<Parameter> parameterFromKey(QStringView key)
{
    for (const Row &row : rows)
        if (key == QLatin1String(row.key))
            return row.parameter;
    return std::nullopt;
}

std::span<const Parameter> allParameters()
{
    return parameters;
}

QString parameterName(Parameter parameter)
{
    return QCoreApplication::translate("Parameter", rowOf(parameter).name);
}

std::optional<std::int64_t> valueOf(const ParameterValues &values, Parameter parameter)
{
    const auto found = std::ranges::find(values, parameter, &ParameterValue::parameter);
    return found == values.end() ? std::nullopt : std::optional(found->value);
}

} // namespace codewheel
