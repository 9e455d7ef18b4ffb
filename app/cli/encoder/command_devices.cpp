// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/explain_word.h"
#include "catalog/hex_code.h"
#include "catalog/kept_values.h"
#include "catalog/protocol_rules.h"
#include "catalog/value_text.h"
#include "cli/bus/device_label.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/device_tables_text.h"
#include "cli/encoder/parameter_arguments.h"
#include "cli/encoder/parameter_text.h"
#include "cli/kinds/link_kind.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

constexpr const char *devicesExamples[] = {"devices", "devices fraba-ocd-ib", "devices baumer-gxp6w --json",
                                           "devices --label OCD-IBA1B-1213-C100-PRI"};

constexpr Option devicesOptions[] = {
    {"--label", "KEY",
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "what the key on a label says, and whose it is")},
    {"--check", "FILE", QT_TRANSLATE_NOOP("codewheel::CommandLine", "whether a description file is valid")},
    busOption,
};

QString yesNo(bool yes)
{
    return yes ? CommandLine::tr("yes") : CommandLine::tr("no");
}

Answer listOf(const Catalog &catalog)
{
    TextTable table;
    table.add({CommandLine::tr("name"), CommandLine::tr("profile"), CommandLine::tr("device code"),
               CommandLine::tr("read-out"), CommandLine::tr("encoder")});
    QJsonArray devices;
    for (const DeviceDescription &device : catalog.devices()) {
        const bool onBus = device.hasWords();
        table.add({device.key, profileName(device.profile),
                   onBus ? hexCode(device.deviceCode, 4) : QStringLiteral("-"),
                   yesNo(device.capabilities.reads), device.fullName()});
        devices.append(QJsonObject{{QStringLiteral("name"), device.key},
                                   {QStringLiteral("vendor"), device.vendor},
                                   {QStringLiteral("model"), device.name},
                                   {QStringLiteral("profile"), profileName(device.profile)},
                                   {QStringLiteral("idCode"), knownJson(device.idCode)},
                                   {QStringLiteral("deviceCode"), knownJson(device.deviceCode)},
                                   {QStringLiteral("reads"), device.capabilities.reads}});
    }
    return {table.toString(), {{QStringLiteral("devices"), devices}}};
}

QString parameterLines(const DeviceDescription &device)
{
    using enum TextTable::Align;
    TextTable table({left, right, right});
    const bool onLine = !device.hasWords();
    table.add({CommandLine::tr("parameter"),
               onLine ? CommandLine::tr("written by") : CommandLine::tr("number"),
               onLine ? CommandLine::tr("read by") : CommandLine::tr("read-out"), CommandLine::tr("factory"),
               CommandLine::tr("unit"), CommandLine::tr("values")});
    for (const ParameterDescription &parameter : device.parameters) {
        const auto reach = protocolRules(device.profile).reachText(parameter);
        table.add({parameterKey(parameter.parameter), orDash(reach.write), orDash(reach.read),
                   parameter.factory ? typedValue(parameter, *parameter.factory) : QStringLiteral("-"),
                   unitText(parameter.unit), rangeText(parameter)});
    }
    return table.toString();
}

// Words have codes, which are numbers; lines have commands, which are letters.
QJsonObject parameterJson(const DeviceDescription &device, const ParameterDescription &parameter)
{
    QJsonArray choices;
    for (const Choice &choice : parameter.choices)
        choices.append(QJsonObject{{QStringLiteral("value"), static_cast<qint64>(choice.value)},
                                   {QStringLiteral("choice"), choice.key}});
    const auto reach = protocolRules(device.profile).reachText(parameter);
    const auto code = [&device](const QString &text) {
        return device.hasWords() && !text.isEmpty() ? QJsonValue(text.toInt()) : QJsonValue();
    };
    const auto letters = [&device](const QString &text) {
        return device.hasWords() || text.isEmpty() ? QJsonValue() : QJsonValue(text);
    };
    QJsonObject json{{QStringLiteral("parameter"), parameterKey(parameter.parameter)},
                     {QStringLiteral("number"), code(reach.write)},
                     {QStringLiteral("readOut"), code(reach.read)},
                     {QStringLiteral("writeCommand"), letters(reach.write)},
                     {QStringLiteral("readCommand"), letters(reach.read)},
                     {QStringLiteral("factory"), numberJson(parameter.factory)},
                     {QStringLiteral("unit"), unitKey(parameter.unit)},
                     {QStringLiteral("chapter"), parameter.chapter.toString()},
                     {QStringLiteral("choices"), choices}};
    if (parameter.isText()) {
        json.insert(QStringLiteral("text"), parameter.textLength);
        return json;
    }
    json.insert(QStringLiteral("minimum"), static_cast<qint64>(parameter.minimum));
    json.insert(QStringLiteral("maximum"), static_cast<qint64>(parameter.maximum));
    return json;
}

QString errorLines(const DeviceDescription &device)
{
    QString text;
    for (const DeviceError &error : device.errors)
        text += explanationText(device, Meaning{MeaningId::deviceError, {error.number}}) + u'\n';
    return text;
}

QString budgetText(const DeviceDescription &device)
{
    const Capabilities &can = device.capabilities;
    if (can.writes && !keepsValues(device))
        return CommandLine::tr("EEPROM writes: none, it keeps no value without supply");
    if (!can.eepromBudget)
        return CommandLine::tr("EEPROM writes: not stated in the manual");
    if (!can.eepromLimit)
        return sentence(CommandLine::tr("EEPROM writes: about %1"),
                        argumentTexts({std::int64_t{*can.eepromBudget}}));
    return sentence(CommandLine::tr("EEPROM writes: about %1, nothing is guaranteed past %2"),
                    argumentTexts({std::int64_t{*can.eepromBudget}, std::int64_t{*can.eepromLimit}}));
}

Answer detailsOf(const DeviceDescription &device)
{
    QString text = QStringLiteral("%1 (%2)\n").arg(device.fullName(), device.manual);
    if (!device.notes.isEmpty())
        text += device.notesText() + u'\n';
    if (!device.parameters.empty())
        text +=
            u'\n' + parameterLines(device) + u'\n' + errorLines(device) + u'\n' + budgetText(device) + u'\n';
    text += deviceTablesText(device);

    QJsonArray parameters;
    for (const ParameterDescription &parameter : device.parameters)
        parameters.append(parameterJson(device, parameter));
    QJsonArray errors;
    for (const DeviceError &error : device.errors)
        errors.append(QJsonObject{{QStringLiteral("number"), static_cast<int>(error.number)},
                                  {QStringLiteral("meaning"), refusalKey(error.meaning)},
                                  {QStringLiteral("warning"), error.warning}});
    return {text,
            {{QStringLiteral("name"), device.key},
             {QStringLiteral("parameters"), parameters},
             {QStringLiteral("errors"), errors},
             {QStringLiteral("eepromBudget"), numberJson(device.capabilities.eepromBudget)},
             {QStringLiteral("eepromLimit"), numberJson(device.capabilities.eepromLimit)},
             {QStringLiteral("tables"), deviceTablesJson(device)}}};
}

Checked<DeviceDescription> asOnLink(const Call &call, DeviceDescription device)
{
    Checked<DeviceDescription> described = std::move(device);
    for (const LinkKind *kind : linkKinds())
        if (described)
            described = kind->asOnLink(call, *std::move(described));
    return described;
}

// Of a description of ours, or of a file of makers that a kind of bus knows.
Answer checkOf(const Call &call, const QString &file)
{
    for (const LinkKind *kind : linkKinds())
        if (auto answer = kind->checkDeviceFile(call, file))
            return *std::move(answer);
    return checkAnswer(file);
}

Checked<Answer> runDevices(const Call &call)
{
    const auto label = call.arguments.value("--label");
    const auto file = call.arguments.value("--check");
    if (label.has_value() + file.has_value() + !call.arguments.rest.isEmpty() > 1)
        return badInput("oneQuestion",
                        CommandLine::tr("Give one of these: a NAME, --label KEY or --check FILE."));
    if (label)
        return labelAnswer(call.catalog, *label);
    if (file)
        return checkOf(call, *file);
    if (const auto bus = call.arguments.value("--bus"))
        if (const auto its = busNamed(call, *bus); !its)
            return tl::unexpected(its.error());
    if (call.arguments.rest.isEmpty())
        return listOf(call.catalog);
    const auto device = deviceNamed(call.catalog, call.arguments.rest.front());
    if (!device)
        return tl::unexpected(device.error());
    const auto onLink = asOnLink(call, **device);
    if (!onLink)
        return tl::unexpected(onLink.error());
    return detailsOf(*onLink);
}

} // namespace

const Subcommand devicesCommand{
    .name = "devices",
    .usage = "[NAME] [--label KEY] [--check FILE] [--bus BUS]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "list the encoders this program knows"),
    .details =
        QT_TRANSLATE_NOOP("codewheel::CommandLine",
                          "Lists the encoders this program knows. With a NAME: its parameters with "
                          "their numbers,\nread-out codes, factory values and ranges, its errors, how often "
                          "its EEPROM can be written, and\nwhat its manual's tables say: pins, LEDs, "
                          "supply, limits, ordering key. Descriptions of your own\nare read from "
                          "~/.local/share/codewheel/devices/*.json; --check tells whether one is sound."),
    .examples = devicesExamples,
    .options = devicesOptions,
    .arguments = {0, 1},
    .needsLinks = true,
    .run = runDevices,
};

} // namespace codewheel
