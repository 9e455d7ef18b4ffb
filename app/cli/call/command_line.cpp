// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/command_line.h"

#include "bus/buses.h"
#include "catalog/catalog.h"
#include "cli/bus/places.h"
#include "cli/call/help.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/completion/complete.h"
#include "cli/journal/ledger_account.h"
#include "cli/kinds/link_kind.h"
#include "cli/project/project_of_call.h"
#include "journal/ledger_keeper.h"
#include "user_devices.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QJsonDocument>

#include <algorithm>

namespace codewheel {
namespace {

QString commandNames()
{
    return listed(allCommands(),
                  [](const Subcommand *command) { return QString::fromLatin1(command->name); });
}

QString jsonText(const QJsonObject &json, const QString &command, bool hasBegun = false)
{
    const Subcommand *known = commandNamed(command);
    if (known != nullptr && known->answersInLines)
        return QString::fromUtf8(QJsonDocument(json).toJson(QJsonDocument::Compact)) + u'\n';
    const QString text = QString::fromUtf8(QJsonDocument(json).toJson());
    return hasBegun ? text.sliced(1) : text; // without its brace
}

QString whatWasDone(const Subcommand &command, const Answer &answer)
{
    const QString done = (command.textIsAccount ? answer.text : QString()) + answer.done;
    return done.isEmpty() ? CommandLine::tr("Nothing was written to any encoder.")
                          : CommandLine::tr("This was done:") + u'\n' + done.trimmed();
}

// The exit code if everything could be printed on standard output; otherwise standard error says what was
// done.
int asTold(int exit, const QString &done, const Terminal &terminal)
{
    if (terminal.canPrint())
        return exit;
    const QString why =
        sentence(CommandLine::tr("Standard output cannot be written: %1."), {terminal.whyNotPrinted()});
    terminal.complain(done.isEmpty() ? why : why + u' ' + done);
    return exit == static_cast<int>(ExitCode::done) ? static_cast<int>(ExitCode::refused) : exit;
}

int fail(const Complaint &complaint, const QString &command, bool asJson, QJsonObject json,
         const Terminal &terminal, bool hasBegunJson = false)
{
    if (asJson) {
        if (!command.isEmpty())
            json.insert(QStringLiteral("command"), command);
        json.insert(QStringLiteral("exit"), static_cast<int>(complaint.exit));
        json.insert(QStringLiteral("error"), errorJson(complaint));
        terminal.print(jsonText(json, command, hasBegunJson));
    }
    terminal.complain((complaint.text + u'\n' + commandToCopy(complaint.command)).trimmed());
    return static_cast<int>(complaint.exit);
}

int fail(const Complaint &complaint, const QString &command, const QStringList &words,
         const Terminal &terminal)
{
    return fail(complaint, command, words.contains(QStringLiteral("--json")), {}, terminal);
}

Complaint aboutUnknownCommand(const QString &name)
{
    return badInput("unknownCommand",
                    CommandLine::tr("There is no command \"%1\". The commands are: %2. See codewheel-cli "
                                    "--help."),
                    {name, commandNames()})
        .value();
}

Complaint aboutMissingCommand()
{
    return badInput("missingCommand", CommandLine::tr("Name a command: %1. See codewheel-cli --help."),
                    {commandNames()})
        .value();
}

Checked<void> checkCount(const Subcommand &command, const Arguments &arguments)
{
    const QString call = callOf(command);
    if (arguments.rest.size() < command.arguments.least)
        return badInput("missingArgument", CommandLine::tr("Something is missing. Usage: codewheel-cli %1"),
                        {call});
    if (arguments.rest.size() > command.arguments.most)
        return badInput("tooManyArguments", CommandLine::tr("\"%1\" is too much. Usage: codewheel-cli %2"),
                        {arguments.rest[command.arguments.most], call});
    return {};
}

bool takesNextWord(const QString &option)
{
    return std::ranges::any_of(commonOptions(), [&](const Option &common) {
        return common.value != nullptr && option == QLatin1String(common.name);
    });
}

bool asksForHelp(const Arguments &arguments)
{
    return arguments.has("--help") || arguments.has("-h");
}

bool needsBus(const Subcommand &command, const Arguments &arguments)
{
    return command.needsBus || (command.busOption != nullptr && arguments.has(command.busOption));
}

using Links = std::vector<std::unique_ptr<BusAccess>>;

// One that cannot be made is left out, and reported.
Checked<Links> makeLinks(const std::vector<MakeLink> &make, const Catalog &catalog, const Terminal &terminal)
{
    Links links;
    std::vector<Complaint> leftOut;
    for (const MakeLink &one : make)
        if (auto link = one(catalog))
            links.push_back(*std::move(link));
        else
            leftOut.push_back(link.error());
    if (links.empty() && !leftOut.empty())
        return tl::unexpected(leftOut.front());
    for (const Complaint &why : leftOut)
        terminal.complain(why.text);
    return links;
}

// Whether it makes sense with one of the links.
Checked<void> checkCommand(const Subcommand &command, const Links &links)
{
    for (const auto &link : links)
        if (!link->whyNot(command))
            return {};
    return tl::unexpected(*links.front()->whyNot(command));
}

Checked<void> startFaultPlan(const Call &call)
{
    const auto file = call.arguments.value("--fault-plan");
    if (!file || call.links.empty())
        return {};
    return ringOfFaults(call).and_then([&](BusAccess *ring) { return ring->followFaultPlan(*file); });
}

// At a port that the project assigns to no bus.
void noteForeignBuses(const Call &call, const Project *project)
{
    if (project == nullptr || !needsBus(call.command, call.arguments))
        return;
    for (const BusAccess *link : call.links)
        if (findBus(*project, link->bus().id()) == nullptr && !link->bus().isSimulated())
            call.terminal.complain(
                sentence(CommandLine::tr("No bus of the project is at %1: what the project says of its "
                                         "encoders does not count for it."),
                         {call.arguments.value("--link").value_or(QString())}));
}

// The devices that a call knows.
struct KnownCatalog
{
    Catalog catalog = Catalog::builtIn();
    std::vector<Catalog::Fault> faults = addUserDevices(catalog, userDeviceFolder());
};

int runOnLinks(const Subcommand &command, const Arguments &arguments, const Project *project,
               const KnownCatalog &known, const std::vector<MakeLink> &make, const Terminal &terminal)
{
    const Catalog &catalog = known.catalog;
    for (const Catalog::Fault &fault : known.faults)
        terminal.complain(
            refusalText({RefusalKind::badInput, RefusalId::deviceFileBroken, {fault.place(), fault.reason}}));
    const bool opens = needsBus(command, arguments);
    auto links = opens || command.needsLinks ? makeLinks(make, catalog, terminal) : Links();
    if (const auto checked = links && opens ? checkCommand(command, *links) : Checked<void>(); !checked)
        links = tl::unexpected(checked.error());
    if (!links)
        return fail(links.error(), QString::fromLatin1(command.name), arguments.has("--json"), {}, terminal);
    std::vector<BusAccess *> accesses;
    for (const auto &link : *links) {
        if (opens)
            link->keepLedger(arguments.value("--ledger"), accesses);
        accesses.push_back(link.get());
    }
    if (opens)
        complainAboutLedgers(accesses, terminal);
    return runCommand(command, arguments, project, catalog, accesses, terminal);
}

// What needs no bus: help and version. `command`: whose; empty for the program itself.
int printed(Answer answer, const Arguments &arguments, const QString &command, const Terminal &terminal)
{
    if (arguments.has("--json")) {
        if (!command.isEmpty())
            answer.json.insert(QStringLiteral("command"), command);
        answer.json.insert(QStringLiteral("exit"), static_cast<int>(ExitCode::done));
        terminal.print(jsonText(answer.json, command));
    } else {
        terminal.print(answer.text);
    }
    return asTold(static_cast<int>(ExitCode::done), {}, terminal);
}

Answer versionAnswer()
{
    return {versionText(), versionJson()};
}

int withoutCommand(const QStringList &words, const Terminal &terminal)
{
    const auto arguments = parseArguments(words, commonOptions(), QStringLiteral("codewheel-cli"));
    if (!arguments)
        return fail(arguments.error(), {}, words, terminal);
    if (arguments->has("--version"))
        return printed(versionAnswer(), *arguments, {}, terminal);
    if (asksForHelp(*arguments))
        return printed({overallHelp(), overallHelpJson()}, *arguments, {}, terminal);
    return fail(aboutMissingCommand(), {}, words, terminal);
}

} // namespace

int runCommand(const Subcommand &command, const Arguments &arguments, const Project *project,
               const Catalog &catalog, const std::vector<BusAccess *> &links, const Terminal &terminal)
{
    const QString name = QString::fromLatin1(command.name);
    const bool asJson = arguments.has("--json");
    Buses buses;
    for (const BusAccess *link : links)
        buses.add(link->bus());
    const Call call{command,
                    arguments,
                    catalog,
                    terminal,
                    links,
                    buses,
                    arguments.has("--project") ? project : nullptr,
                    command.namesProject ? project : nullptr};
    const BusNames names(call);
    if (call.project != nullptr)
        useProject(call, *call.project, *arguments.value("--project"));
    else if (call.named != nullptr)
        nameBuses(call, *call.named);
    if (const auto follows = startFaultPlan(call); !follows)
        return fail(follows.error(), name, asJson, {}, terminal);
    noteForeignBuses(call, project);
    const LedgerAccount account(links, terminal);
    auto answer = command.run(call);
    if (!answer)
        return fail(answer.error(), name, asJson, {}, terminal);
    if (!answer->complaint)
        answer->complaint = account.complaint();
    if (!asJson)
        terminal.print(answer->text);
    const QString done = whatWasDone(command, *answer);
    if (answer->complaint)
        return asTold(fail(*answer->complaint, name, asJson, answer->json, terminal, answer->hasBegunJson),
                      done, terminal);
    if (asJson) {
        QJsonObject json = answer->json;
        json.insert(QStringLiteral("command"), name);
        json.insert(QStringLiteral("exit"), static_cast<int>(ExitCode::done));
        terminal.print(jsonText(json, name, answer->hasBegunJson));
    }
    return asTold(static_cast<int>(ExitCode::done), done, terminal);
}

bool makesPdf(const QStringList &words)
{
    return words.contains(QLatin1String(reportCommand.name)) &&
           std::ranges::any_of(words, [](const QString &word) {
               return word.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive);
           });
}

// The command is the first word that is not an option; the common options may come before it.
int runCommandLine(const QStringList &words, const Terminal &terminal)
{
    if (isCompletion(words))
        return complete(words, terminal);
    qsizetype place = 0;
    while (place < words.size() && words[place].startsWith(u'-'))
        place += takesNextWord(words[place]) ? 2 : 1;
    if (place >= words.size())
        return withoutCommand(words, terminal);

    const QString &name = words[place];
    const Subcommand *command = commandNamed(name);
    if (!command)
        return fail(aboutUnknownCommand(name), {}, words, terminal);
    const QStringList behind = words.first(place) + words.sliced(place + 1);
    const auto arguments = parseArguments(behind, optionsOf(*command), name);
    if (!arguments)
        return fail(arguments.error(), name, words, terminal);
    if (arguments->has("--version"))
        return printed(versionAnswer(), *arguments, name, terminal);
    if (asksForHelp(*arguments))
        return printed({helpOf(*command), helpJsonOf(*command)}, *arguments, name, terminal);
    const KnownCatalog known; // before the project: it names parameters of its devices
    const auto project = projectOf(*command, *arguments);
    if (!project)
        return fail(project.error(), name, words, terminal);
    const Project *its = *project ? &**project : nullptr;
    const auto links = linksMeant(arguments->value("--link").value_or(QStringLiteral("training")), its);
    if (!links)
        return fail(links.error(), name, words, terminal);
    if (const auto checked = checkCount(*command, *arguments); !checked)
        return fail(checked.error(), name, words, terminal);
    return runOnLinks(*command, *arguments, its, known, *links, terminal);
}

} // namespace codewheel
