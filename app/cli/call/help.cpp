// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/help.h"

#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/kinds/link_kind.h"
#include "vocabulary/sentence.h"

#include <QJsonArray>

namespace codewheel {
namespace {

QString optionLines(std::span<const Option> options)
{
    TextTable table;
    for (const Option &option : options) {
        if (!option.help) // a short form of the previous one
            continue;
        QString name = QString::fromLatin1(option.name);
        if (option.value)
            name += u' ' + QString::fromLatin1(option.value);
        table.add({name, CommandLine::tr(option.help)});
    }
    return table.toString(2);
}

QString exampleLines(std::span<const char *const> examples)
{
    QString text;
    for (const char *example : examples)
        text += QStringLiteral("  codewheel-cli ") + QString::fromLatin1(example) + u'\n';
    return text;
}

QJsonArray optionsJson(std::span<const Option> options)
{
    QJsonArray json;
    for (const Option &option : options)
        json.append(QJsonObject{
            {QStringLiteral("name"), QString::fromLatin1(option.name)},
            {QStringLiteral("value"),
             option.value ? QJsonValue(QString::fromLatin1(option.value)) : QJsonValue()},
            {QStringLiteral("help"), option.help ? QJsonValue(CommandLine::tr(option.help)) : QJsonValue()}});
    return json;
}

QJsonArray examplesJson(std::span<const char *const> examples)
{
    QJsonArray json;
    for (const char *example : examples)
        json.append(QStringLiteral("codewheel-cli ") + QString::fromLatin1(example));
    return json;
}

QString usageOf(const Subcommand &command)
{
    return QStringLiteral("codewheel-cli ") + callOf(command).trimmed();
}

// "esc [--lost N] [--echo] | modbus-tcp [--port PORT]"
QString usageOfServices(const std::vector<Service> &services)
{
    QStringList all;
    for (const Service &service : services) {
        QString one = QString::fromLatin1(service.name);
        for (const Option &option : service.options)
            one += QStringLiteral(" [%1]").arg(
                QStringLiteral("%1 %2")
                    .arg(QString::fromLatin1(option.name), QString::fromLatin1(option.value))
                    .trimmed());
        all << one;
    }
    return all.join(QStringLiteral(" | "));
}

constexpr const char *overallExamples[] = {
    "scan",
    "explain C20000FF --device fraba-ocd-ib --direction in",
    "words 1.0 020000FF 04000001 06000003 08000000 80000000 00000000",
    "write 1.0 steps=255 revolutions=1 direction=cw preset=0 --yes --trace",
    "read 05 --link esc:ttyUSB0,baud=9600",
};

QString overallNotes()
{
    return CommandLine::tr(
        "PLACE is the device number of an encoder, segment.position: 1.0; on a serial line its "
        "address,\n"
        "two hexadecimal digits: 12, or esc:12; or its station in the project. Where several buses "
        "have it,\n"
        "BUS/PLACE names one, BUS being its name in the project, else Ring or Line, or its number. "
        "Numbers\n"
        "are decimal unless they are written 0x.. or ..h; a WORD is always hexadecimal, as the "
        "manuals print it.\n"
        "\n"
        "Each call has a new training bus, which always starts the same: 1.0 FRABA K3 that stands\n"
        "still, 2.0 Baumer K3 that turns at 10 rpm, 3.0 FRABA K1, 4.0 FRABA K2, 5.0 TR LA-66 on a "
        "rod,\n"
        "6.0 bus terminal and, behind it, 6.1 FRABA K3 on Loop 2; and a serial line with the Kübler\n"
        "encoders 03, 05 and 12. What one call wrote, the next one does not find.\n"
        "\n"
        "Exit code: 0 done; 1 not done, not known, or done and not told; 2 bad input.\n"
        "codewheel-cli COMMAND --help explains a command.");
}

} // namespace

QString callOf(const Subcommand &command)
{
    return QStringLiteral("%1 %2").arg(QString::fromLatin1(command.name),
                                       &command == &serveCommand ? usageOfServices(allServices())
                                                                 : QString::fromLatin1(command.usage));
}

QString overallHelp()
{
    TextTable commands;
    for (const Subcommand *command : allCommands())
        commands.add({QString::fromLatin1(command->name), CommandLine::tr(command->summary)});
    return CommandLine::tr(
               "codewheel-cli sets up, watches and diagnoses absolute encoders on INTERBUS, CANopen and "
               "serial lines.") +
           QStringLiteral("\n\n") + CommandLine::tr("Usage: codewheel-cli COMMAND ...") +
           QStringLiteral("\n\n") + CommandLine::tr("Commands:") + u'\n' + commands.toString(2) + u'\n' +
           CommandLine::tr("Options of every command:") + u'\n' + optionLines(commonOptions()) + u'\n' +
           CommandLine::tr("Examples:") + u'\n' + exampleLines(overallExamples) + u'\n' + overallNotes() +
           u'\n';
}

QString helpOf(const Subcommand &command)
{
    QString text = sentence(CommandLine::tr("Usage: codewheel-cli %1"), {callOf(command)}) +
                   QStringLiteral("\n\n") + CommandLine::tr(command.details) + QStringLiteral("\n\n");
    if (const auto own = ownOptionsOf(command); !own.empty())
        text += CommandLine::tr("Options:") + u'\n' + optionLines(own) + u'\n';
    return text + CommandLine::tr("Options of every command:") + u'\n' + optionLines(commonOptions()) +
           u'\n' + CommandLine::tr("Examples:") + u'\n' + exampleLines(command.examples);
}

QJsonObject overallHelpJson()
{
    QJsonArray commands;
    for (const Subcommand *command : allCommands())
        commands.append(QJsonObject{{QStringLiteral("name"), QString::fromLatin1(command->name)},
                                    {QStringLiteral("usage"), usageOf(*command)},
                                    {QStringLiteral("summary"), CommandLine::tr(command->summary)}});
    QJsonObject json = versionJson();
    json.insert(QStringLiteral("usage"), QStringLiteral("codewheel-cli COMMAND ..."));
    json.insert(QStringLiteral("commands"), commands);
    json.insert(QStringLiteral("options"), optionsJson(commonOptions()));
    json.insert(QStringLiteral("examples"), examplesJson(overallExamples));
    json.insert(QStringLiteral("notes"), overallNotes());
    return json;
}

QJsonObject helpJsonOf(const Subcommand &command)
{
    return {{QStringLiteral("usage"), usageOf(command)},
            {QStringLiteral("summary"), CommandLine::tr(command.summary)},
            {QStringLiteral("details"), CommandLine::tr(command.details)},
            {QStringLiteral("options"), optionsJson(optionsOf(command))},
            {QStringLiteral("examples"), examplesJson(command.examples)}};
}

QJsonObject versionJson()
{
    return {{QStringLiteral("program"), QStringLiteral("codewheel-cli")},
            {QStringLiteral("version"), QStringLiteral(CODEWHEEL_VERSION)}};
}

QString versionText()
{
    return QStringLiteral("codewheel-cli %1\n").arg(QStringLiteral(CODEWHEEL_VERSION));
}

} // namespace codewheel
