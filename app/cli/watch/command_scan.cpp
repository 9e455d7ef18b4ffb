// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/encoder_bus.h"
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/kinds/link_kind.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "project/file_access.h"
#include "project/project_file.h"
#include "vocabulary/sentence.h"

#include <QFileInfo>
#include <QJsonArray>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr const char *scanExamples[] = {"scan", "scan --json", "scan --link esc:training --all-rates",
                                        "scan --link canopen:training --ask"};

constexpr std::array scanOptions{
    Option{"--save", "FILE", QT_TRANSLATE_NOOP("codewheel::CommandLine", "save what was found as a project")},
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "replace FILE if it is there")},
};

// An option of a kind of bus would have no effect if the link leads to none of that kind.
Checked<void> checkOptionsOfKinds(const Call &call)
{
    for (const LinkKind *kind : linkKinds()) {
        if (std::ranges::count(call.links, kind->bus(), &BusAccess::kind) > 0)
            continue;
        for (const Option &option : kind->scanOptions())
            if (call.arguments.has(option.name))
                return badInput("optionOfOtherBus",
                                CommandLine::tr("%1 is for a bus that the link does not lead to: %2. "
                                                "Leave it out."),
                                {QString::fromLatin1(option.name), busKind(kind->bus())->title()});
    }
    return {};
}

// A scan must not overwrite a file.
Checked<void> checkProjectIsFree(const Arguments &arguments)
{
    const auto file = arguments.value("--save");
    if (!file || arguments.has("--yes") || !QFileInfo::exists(*file))
        return {};
    return badInput("fileExists",
                    CommandLine::tr("%1 is there already. Nothing was saved. Name another file, or add --yes "
                                    "to replace it; the old one is kept as %2."),
                    {*file, backupPath(*file)});
}

// What the project of the call knows stays with the devices that are the same or moved. Its other buses stay.
Project foundProject(const Call &call, const std::vector<BusAccess *> &buses)
{
    Project found;
    found.buses.clear();
    if (call.project != nullptr)
        found = *call.project;
    for (const BusAccess *bus : buses) {
        planBus(found, bus->bus().id(), *busKind(bus->kind()));
        bus->keepFound(call, found);
    }
    return found;
}

bool areSameFile(const QString &one, const QString &other)
{
    const QString path = QFileInfo(one).canonicalFilePath();
    return !path.isEmpty() && path == QFileInfo(other).canonicalFilePath();
}

// Nothing else shows that a bus of the link is not in the project.
QString newBuses(const Call &call, const Project &found)
{
    QStringList names;
    if (call.project != nullptr)
        for (const PlannedBus &bus : found.buses)
            if (findBus(*call.project, bus.id) == nullptr)
                names << bus.name;
    return names.isEmpty() ? QString()
                           : sentence(CommandLine::tr("Saved as a new bus, beside those of the project: %1."),
                                      {names.join(QStringLiteral(", "))}) +
                                 u'\n';
}

void saveFound(const Call &call, const std::vector<BusAccess *> &buses, Answer &answer)
{
    const auto file = call.arguments.value("--save");
    if (!file)
        return;
    const bool isProject = call.project != nullptr && areSameFile(*file, *call.arguments.value("--project"));
    const Project found = foundProject(call, buses);
    for (const BusAccess *bus : buses)
        if (bus->hasFoundNobody() && !devicesOn(found, bus->bus().id()).empty())
            answer.done += sentence(CommandLine::tr("%1: nothing answers there. The encoders that are "
                                                    "planned on it stay in the project."),
                                    {bus->name()}) +
                           u'\n';
    const auto saved =
        isProject ? saveProjectOver(projectMark(*call.project), found, *file) : saveProject(found, *file);
    if (!saved) {
        answer.done.clear();
        answer.complaint = complaintAbout(saved.error());
        return;
    }
    answer.done += sentence(CommandLine::tr("Saved in %1."), {*file}) + u'\n' + newBuses(call, found);
    answer.text += answer.done;
    answer.json.insert(QStringLiteral("saved"), *file);
}

// With several buses each gets a heading. "buses" has what each of them reports, and what only one of them
// reports is also given at the top level.
void addFound(const Call &call, const BusAccess &bus, const Answer &found, QJsonArray &buses, Answer &answer)
{
    QJsonObject json = found.json;
    addBus(json, bus);
    json.insert(QStringLiteral("kind"), bus.kind());
    if (found.complaint)
        json.insert(QStringLiteral("error"), errorJson(*found.complaint));
    buses.append(json);
    for (auto one = found.json.begin(); one != found.json.end(); ++one)
        if (!answer.json.contains(one.key()))
            answer.json.insert(one.key(), one.value());
    if (call.links.size() > 1)
        answer.text += (answer.text.isEmpty() ? QString() : QStringLiteral("\n")) +
                       sentence(CommandLine::tr("%1: %2"), {bus.name(), busKind(bus.kind())->title()}) +
                       u'\n';
    answer.text += found.complaint && found.text.isEmpty() ? found.complaint->text + u'\n' : found.text;
    if (!answer.complaint)
        answer.complaint = found.complaint;
}

Complaint aboutNoSearch()
{
    return notDone("notSearched", CommandLine::tr("Not searched any more: the search was cancelled."));
}

bool wasCancelled(const Answer &answer)
{
    return answer.complaint && answer.complaint->key == QStringLiteral("scanCancelled");
}

// A refusal by one bus does not keep the others from being scanned.
Checked<Answer> runScan(const Call &call)
{
    if (const auto checked = checkOptionsOfKinds(call); !checked)
        return tl::unexpected(checked.error());
    if (const auto isFree = checkProjectIsFree(call.arguments); !isFree)
        return tl::unexpected(isFree.error());
    for (const BusAccess *bus : call.links)
        if (const auto can = bus->checkScan(call); !can)
            return tl::unexpected(can.error());
    Answer answer;
    QJsonArray buses;
    std::vector<BusAccess *> found;
    for (BusAccess *bus : call.links) {
        if (wasCancelled(answer)) {
            addFound(call, *bus, {.complaint = aboutNoSearch()}, buses, answer);
            continue;
        }
        const auto its = bus->scan(call);
        if (!its && call.links.size() == 1)
            return tl::unexpected(its.error());
        if (its)
            found.push_back(bus);
        addFound(call, *bus,
                 its.value_or(Answer{.complaint = its ? std::nullopt : std::optional(its.error())}), buses,
                 answer);
    }
    answer.json.insert(QStringLiteral("buses"), buses);
    if (!wasCancelled(answer)) // what was no longer searched for is not gone
        saveFound(call, found, answer);
    return answer;
}

} // namespace

const Subcommand scanCommand{
    .name = "scan",
    .usage = "[--save FILE] [--yes] [--all-rates] [--master] [--first ADDRESS] [--last ADDRESS] "
             "[--ask] [--listen SECONDS]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                 "list the participants of the bus, and look for encoders on a serial line"),
    .details =
        QT_TRANSLATE_NOOP("codewheel::CommandLine",
                          "Lists the participants of the bus in ring order, with their ID codes and "
                          "words (16 bit each), and tells how the master stands.\nThe ID code tells "
                          "the profile but not the make: that "
                          "is named where the plan of the bus tells it.\nSends nothing on the bus.\n\n"
                          "On a serial line each address is asked for its serial number, and who "
                          "answers for device code and\nversion. Nothing is written. Ctrl+C ends it, and "
                          "lists what was found until then.\n\n"
                          "On a CAN bus it listens to what nodes tell, and sends nothing; with --ask each "
                          "node is asked what it\nis.\n\n"
                          "--save makes a project of it. With --project as well, what that project "
                          "knows of devices\nthat are still there is taken along."),
    .examples = scanExamples,
    .options = scanOptions,
    .arguments = {0},
    .needsBus = true,
    .run = runScan,
};

} // namespace codewheel
