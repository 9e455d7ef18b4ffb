// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/parameter_rules.h"

#include "catalog/data_field.h"
#include "catalog/protocol_row.h"

#include <algorithm>

namespace codewheel {
namespace {

// The number of the word that sets a K3 to default (FRABA manual 5.3, Baumer manual 5).
constexpr unsigned resetNumber = 7;

QString shownPlace(std::optional<unsigned> number)
{
    return number ? QString::number(*number) : QString();
}

QString shownPlace(std::optional<esc::Command> command)
{
    return command ? QLatin1StringView(esc::shapeOf(*command).letters) : QString();
}

class ParameterRules
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DescriptionRules)

public:
    static void checkRange(const JsonObject &row, const ParameterDescription &parameter, Profile profile)
    {
        if (!parameter.number)
            return;
        const QString reason =
            tr("A value that is written must be between 0 and %1: the word has no room for others.")
                .arg(largestData(profile));
        if (parameter.minimum < 0)
            row.report("minimum", reason);
        if (parameter.maximum > largestData(profile))
            row.report("maximum", reason);
    }

    // The word 2021000n is known of FRABA alone, and 0E000000 is none that writes a value.
    static void checkK3Words(const JsonObject &row, const ParameterDescription &parameter,
                             const DeviceDescription &device)
    {
        if (parameter.number == resetNumber)
            row.report("number", tr("Parameter number %1 sets all values to default. It cannot be the "
                                    "number of a parameter, too.")
                                     .arg(resetNumber));
        if (parameter.readOut && device.dialect != k3::Dialect::fraba)
            row.report("readOut", tr("Only with the dialect fraba are the words of a read-out known. "
                                     "Leave it out."));
    }

    template <typename Value>
    static void checkSame(const JsonObject &row, const char *key, const Value &given, const Value &known,
                          const QString &owner)
    {
        if (given == known)
            return;
        row.report(key, known
                            ? tr("%1 has %2 here. Anything else makes the encoder do or tell something else.")
                                  .arg(owner, shownPlace(known))
                            : tr("%1 has nothing here. Leave it out: the encoder would do or tell something "
                                 "else.")
                                  .arg(owner));
    }

    static QString ownerText(const ParameterDescription &parameter, Profile profile)
    {
        return tr("%1 of the profile %2", "a parameter, as subject of a sentence")
            .arg(parameterKey(parameter.parameter), profileName(profile));
    }

    // What is not read, or not written, may be left out.
    static void checkServices(const JsonObject &row, const ParameterDescription &parameter)
    {
        const ProtocolRow known = protocolRow(Profile::la66, parameter.parameter);
        const QString owner = ownerText(parameter, Profile::la66);
        if (parameter.number)
            checkSame(row, "number", parameter.number, known.number, owner);
        if (parameter.readOut)
            checkSame(row, "readOut", parameter.readOut, known.readOut, owner);
        if (parameter.number && !parameter.readOut)
            row.report("readOut", tr("What is written must be read, too: it is read back."));
    }

    static void checkCommandNames(const JsonObject &row, const ParameterDescription &parameter)
    {
        const ProtocolRow known = protocolRow(Profile::esc, parameter.parameter);
        const QString owner = ownerText(parameter, Profile::esc);
        if (parameter.writeCommand)
            checkSame(row, "write", parameter.writeCommand, known.writeCommand, owner);
        if (parameter.readCommand) {
            checkSame(row, "read", parameter.readCommand, known.readCommand, owner);
            checkSame(row, "bit", parameter.readBit, known.readBit, owner);
        }
    }

    // The command has no digits for others. A baud rate is told by its number.
    static void checkCommandRange(const JsonObject &row, const ParameterDescription &parameter,
                                  esc::Command command)
    {
        if (command == esc::Command::writeBaudRate) {
            const auto isKnown = [](const Choice &choice) {
                return choice.value == 19200 || choice.value == 9600 || choice.value == 4800;
            };
            if (parameter.choices.empty() || !std::ranges::all_of(parameter.choices, isKnown))
                row.report("choices", tr("A baud rate is 19200, 9600 or 4800."));
            return;
        }
        const esc::CommandShape &shape = esc::shapeOf(command);
        if (parameter.minimum < shape.minimum || parameter.maximum > shape.maximum)
            row.report("maximum", tr("A value that is written must be between %1 and %2.")
                                      .arg(shape.minimum)
                                      .arg(shape.maximum));
    }

    // A device on a serial line has commands, all others have words.
    static void checkCommands(const JsonObject &row, const ParameterDescription &parameter)
    {
        for (const char *key : {"number", "readOut"})
            if (row.has(key))
                row.report(key,
                           tr("An encoder on a serial line has the commands read and write. Leave it out."));
        const bool isFoundAgain =
            parameter.parameter == Parameter::lineAddress || parameter.parameter == Parameter::baudRate;
        if (parameter.writeCommand && !parameter.readCommand && !isFoundAgain)
            row.report("write",
                       tr("What is written must be read, too: a write without an answer is checked."));
        checkCommandNames(row, parameter);
        if (parameter.writeCommand)
            checkCommandRange(row, parameter, *parameter.writeCommand);
        else if (parameter.parameter == Parameter::preset) // the position that is sent
            checkCommandRange(row, parameter, esc::Command::writePreset);
    }

    static void refuseCommands(const JsonObject &row)
    {
        for (const char *key : {"read", "write", "bit"})
            if (row.has(key))
                row.report(key, tr("Only an encoder on a serial line has commands. Leave it out."));
    }

    static void refuseParameters(const JsonObject &row, const ParameterDescription &parameter,
                                 Profile profile)
    {
        for (const char *key : {"number", "readOut"})
            if (row.has(key) && !parameter.onLabel)
                row.report(key, tr("An encoder of the profile %1 has no parameters that this program could "
                                   "write or read. Leave it out.")
                                    .arg(profileName(profile)));
    }
};

} // namespace

bool hasParameters(Profile profile)
{
    return profile == Profile::k3 || profile == Profile::la66 || profile == Profile::esc;
}

void checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                    const DeviceDescription &device)
{
    if (device.profile == Profile::esc) {
        ParameterRules::checkCommands(row, parameter);
        return;
    }
    ParameterRules::refuseCommands(row);
    if (!hasParameters(device.profile)) {
        ParameterRules::refuseParameters(row, parameter, device.profile);
        return;
    }
    ParameterRules::checkRange(row, parameter, device.profile);
    if (device.profile == Profile::k3)
        ParameterRules::checkK3Words(row, parameter, device);
    else
        ParameterRules::checkServices(row, parameter);
}

} // namespace codewheel
