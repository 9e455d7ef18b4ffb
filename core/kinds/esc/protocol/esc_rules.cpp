// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/protocol_rules.h"
#include "kinds/esc/esc_protocols.h"
#include "kinds/esc/protocol/esc_command.h"
#include "kinds/esc/protocol/esc_forms.h"
#include "kinds/esc/protocol/esc_reach.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using esc::Command;

// What the protocol offers for a parameter.
struct Row
{
    Parameter parameter;
    std::optional<Command> read{};
    std::optional<Command> write{};
    std::optional<unsigned> bit{}; // of the operating parameters

    static QString letters(const std::optional<Command> &command)
    {
        return command ? QLatin1StringView(esc::shapeOf(*command).letters) : QString();
    }
};

constexpr std::array escRuleRows{
    Row{Parameter::steps, Command::stepsPerTurn, Command::writeStepsPerTurn},
    Row{Parameter::revolutions, Command::revolutions, Command::writeRevolutions},
    Row{Parameter::measuringRange, Command::measuringRange, Command::writeMeasuringRange},
    Row{Parameter::scalingFactor, Command::scalingFactor, Command::writeScalingFactor},
    Row{Parameter::scaling, Command::operatingParameters, Command::writeScaling, 2},
    Row{Parameter::direction, Command::operatingParameters, Command::writeDirection, 0},
    Row{Parameter::lowerLimit, Command::lowerLimit, Command::writeLowerLimit},
    Row{Parameter::upperLimit, Command::upperLimit, Command::writeUpperLimit},
    Row{Parameter::lineAddress, {}, Command::writeAddress},
    Row{Parameter::baudRate, {}, Command::writeBaudRate},
    Row{Parameter::preset, Command::preset}, // writePreset moves the position
    Row{Parameter::offset, Command::offset},
    Row{Parameter::serialNumber, Command::serialNumber},
    Row{Parameter::operatingTime, Command::operatingTime},
    Row{Parameter::operatingParameters, Command::operatingParameters},
    Row{Parameter::alarms, Command::alarms},
    Row{Parameter::warnings, Command::warnings},
    Row{Parameter::deviceCode, Command::deviceCode},
};

Row rowOf(Parameter parameter)
{
    const auto found = std::ranges::find(escRuleRows, parameter, &Row::parameter);
    return found == escRuleRows.end() ? Row{parameter} : *found;
}

class EscRules final : public ProtocolRules
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DescriptionRules)

public:
    bool hasParameters() const override { return true; }
    int positionBits(const DeviceDescription & /*device*/) const override { return 25; }
    bool presetsByCommand() const override { return true; }
    std::int64_t largestData() const override { return 0xFFFF'FFFF; } // 8 hexadecimal digits

    void complete(ParameterDescription &parameter) const override
    {
        if (parameter.canBeRead || parameter.canBeWritten)
            parameter.form = escForm(parameter.parameter);
    }
    void readReach(const JsonObject &row, ParameterDescription &parameter,
                   const DeviceDescription &before) const override;
    ReachText reachText(const ParameterDescription &parameter) const override;
    void checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                        const DeviceDescription &device) const override;
    void checkPresets(const JsonObject &json, const DeviceDescription &device) const override;

private:
    static std::optional<Command> commandOf(const JsonObject &row, const char *key, const QByteArray &letters,
                                            bool writes);
    static void checkCommandRange(const JsonObject &row, const ParameterDescription &parameter,
                                  Command command);
};

std::optional<Command> EscRules::commandOf(const JsonObject &row, const char *key, const QByteArray &letters,
                                           bool writes)
{
    if (letters.isEmpty())
        return std::nullopt;
    const auto command = esc::commandOf(letters);
    if (!command || esc::shapeOf(*command).writes != writes || esc::shapeOf(*command).digits == 0)
        row.report(key, (writes ? tr("\"%1\" is not a command that writes a value.")
                                : tr("\"%1\" is not a command that reads a value."))
                            .arg(QString::fromLatin1(letters)));
    return command;
}

// The command has no digits for others. A baud rate is given by its number.
void EscRules::checkCommandRange(const JsonObject &row, const ParameterDescription &parameter,
                                 Command command)
{
    if (command == Command::writeBaudRate) {
        const auto isKnown = [](const Choice &choice) {
            return choice.value == 19200 || choice.value == 9600 || choice.value == 4800;
        };
        if (parameter.choices.empty() || !std::ranges::all_of(parameter.choices, isKnown))
            row.report("choices", tr("A baud rate is 19200, 9600 or 4800."));
        return;
    }
    const esc::CommandShape &shape = esc::shapeOf(command);
    if (parameter.minimum < shape.minimum || parameter.maximum > shape.maximum)
        row.report(
            "maximum",
            tr("A value that is written must be between %1 and %2.").arg(shape.minimum).arg(shape.maximum));
}

void EscRules::readReach(const JsonObject &row, ParameterDescription &parameter,
                         const DeviceDescription &before) const
{
    constexpr std::int64_t highestBit = 31;
    const auto bit = row.optionalNumber("bit", 0, highestBit);
    const EscReach reach{.read = row.textOr("read", {}).toLatin1(),
                         .bit = bit ? std::optional(static_cast<unsigned>(*bit)) : std::nullopt,
                         .write = row.textOr("write", {}).toLatin1()};
    if (reach.bit && reach.read.isEmpty())
        row.report("bit", tr("A bit is one of the answer to a command read, and there is none."));
    const auto isTaken = [&before](const auto &isSame) {
        return std::ranges::any_of(
            before.parameters, [&](const ParameterDescription &other) { return isSame(escReach(other)); });
    };
    if (!reach.write.isEmpty() && isTaken([&](const EscReach &other) { return other.write == reach.write; }))
        row.report("write", tr("This command is here twice."));
    if (!reach.read.isEmpty() &&
        isTaken([&](const EscReach &other) { return other.read == reach.read && other.bit == reach.bit; }))
        row.report("read", tr("This command is here twice."));
    parameter.reach = KindData(reach);
    parameter.canBeRead = !reach.read.isEmpty();
    parameter.canBeWritten = !reach.write.isEmpty();
}

ProtocolRules::ReachText EscRules::reachText(const ParameterDescription &parameter) const
{
    const EscReach reach = escReach(parameter);
    return {.write = QString::fromLatin1(reach.write), .read = QString::fromLatin1(reach.read)};
}

void EscRules::checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                              const DeviceDescription &device) const
{
    for (const char *key : {"number", "readOut"})
        if (row.has(key))
            row.report(key, tr("An encoder on a serial line has the commands read and write. Leave it out."));
    const EscReach reach = escReach(parameter);
    const auto read = commandOf(row, "read", reach.read, false);
    const auto write = commandOf(row, "write", reach.write, true);
    const bool isFoundAgain =
        parameter.parameter == Parameter::lineAddress || parameter.parameter == Parameter::baudRate;
    if (write && !read && !isFoundAgain)
        row.report("write", tr("What is written must be read, too: a write without an answer is checked."));
    const Row known = rowOf(parameter.parameter);
    const auto check = [&](const char *key, const QString &given, const QString &wanted) {
        checkPlace(row, key, given, wanted, parameter, device.profile);
    };
    if (write)
        check("write", Row::letters(write), Row::letters(known.write));
    if (read) {
        const auto text = [](std::optional<unsigned> bit) { return bit ? QString::number(*bit) : QString(); };
        check("read", Row::letters(read), Row::letters(known.read));
        check("bit", text(reach.bit), text(known.bit));
    }
    if (write)
        checkCommandRange(row, parameter, *write);
    else if (parameter.parameter == Parameter::preset) // the position that is sent
        checkCommandRange(row, parameter, Command::writePreset);
}

void EscRules::checkPresets(const JsonObject &json, const DeviceDescription &device) const
{
    const ParameterDescription *preset = device.find(Parameter::preset);
    if (!preset || !preset->canBeRead)
        json.report("presets", tr("The parameter preset tells the range of the position, and is read "
                                  "after it was set. Give preset the command read, or write false."));
}

} // namespace

const ProtocolRules &escRules()
{
    static const EscRules rules;
    return rules;
}

} // namespace codewheel
