// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "cli/commands.h"
#include "cli/device_text.h"
#include "cli/json.h"
#include "cli/line_access.h"
#include "cli/master_text.h"
#include "cli/scan_line.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "encoder/sentence.h"
#include "project/file_access.h"
#include "project/project_file.h"
#include "project/project_take_over.h"
#include "ring/bus_session.h"

#include <QFileInfo>

#include <array>
#include <numeric>

namespace codewheel {
namespace {

constexpr const char *scanExamples[] = {"scan", "scan --json", "scan --link esc:training --all-rates"};

constexpr std::array scanOptions{
    Option{"--save", "FILE", QT_TRANSLATE_NOOP("codewheel::CommandLine", "save what was found as a project")},
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "replace FILE if it is there")},
    scanLineOptions[0],
    scanLineOptions[1],
    scanLineOptions[2],
    scanLineOptions[3],
};

// The ID code tells the profile, never the make of an encoder; that is the plan's to name.
QString makeOf(const Participant &participant, const DeviceDescription *named)
{
    return named || participant.idCode == busTerminalIdCode ? participantName(participant, named)
                                                            : CommandLine::tr("make not known");
}

// What is in a file is not lost by a scan.
Checked<void> checkProjectIsFree(const Arguments &arguments)
{
    const auto file = arguments.value("--save");
    if (!file || arguments.has("--yes") || !QFileInfo::exists(*file))
        return {};
    return badInput(QStringLiteral("fileExists"),
                    CommandLine::tr("%1 is there already. Nothing was saved. Name another file, or add --yes "
                                    "to replace it; the old one is kept as %2."),
                    {*file, backupPath(*file)});
}

// What the project of the call knows stays with the devices that are the same or moved.
Project foundProject(const Call &call)
{
    const RingStructure &found = call.bus->structure();
    const Project before = call.project ? *call.project : Project();
    const Comparison comparison = compareRings(structureOf(before), found);
    std::vector<std::size_t> lines(comparison.size());
    std::iota(lines.begin(), lines.end(), std::size_t{0});
    return takenOver(before, found, comparison, lines);
}

bool areSameFile(const QString &one, const QString &other)
{
    const QString path = QFileInfo(one).canonicalFilePath();
    return !path.isEmpty() && path == QFileInfo(other).canonicalFilePath();
}

void saveFound(const Call &call, Answer &answer)
{
    const auto file = call.arguments.value("--save");
    if (!file)
        return;
    const bool isProject = call.project != nullptr && areSameFile(*file, *call.arguments.value("--project"));
    const Project found = foundProject(call);
    const auto saved =
        isProject ? saveProjectOver(projectMark(*call.project), found, *file) : saveProject(found, *file);
    if (!saved) {
        answer.complaint = complaintAbout(saved.error());
        return;
    }
    answer.done = sentence(CommandLine::tr("Saved in %1."), {*file}) + u'\n';
    answer.text += answer.done;
    answer.json.insert(QStringLiteral("saved"), *file);
}

Answer scanRing(const Call &call)
{
    using enum TextTable::Align;
    TextTable table({left, left, left, right, right});
    table.add({CommandLine::tr("place"), CommandLine::tr("ID code"), CommandLine::tr("device code"),
               CommandLine::tr("IN words"), CommandLine::tr("OUT words"), CommandLine::tr("profile"),
               CommandLine::tr("device")});
    QJsonArray devices;
    for (const Participant &participant : call.bus->structure()) {
        const DeviceDescription *named = call.catalog.find(participant.deviceKey);
        const DeviceDescription *known = named ? named : call.catalog.generic(participant.deviceCode);
        const QString profile = known ? profileName(known->profile) : QStringLiteral("-");
        table.add({participant.number.toString(),
                   QStringLiteral("%1 (%2)").arg(hexCode(participant.idCode, 2)).arg(participant.idCode),
                   hexCode(participant.deviceCode, 4), QString::number(participant.inWords),
                   QString::number(participant.outWords), profile, makeOf(participant, named)});
        QJsonObject json = participantJson(&participant).toObject();
        json.insert(QStringLiteral("profile"), known ? QJsonValue(profile) : QJsonValue());
        devices.append(json);
    }
    return Answer{
        table.toString() + u'\n' + masterLines(*call.bus),
        {{QStringLiteral("participants"), devices}, {QStringLiteral("master"), masterJson(*call.bus)}}};
}

// What is found on the line stands beside what is in the ring.
Checked<void> addLine(const Call &call, Answer &answer)
{
    const auto line = scanLine(call);
    if (!line)
        return tl::unexpected(line.error());
    answer.text += u'\n' + CommandLine::tr("On the serial line:") + u'\n' + line->text;
    answer.json.insert(QStringLiteral("encoders"), line->json[QStringLiteral("encoders")]);
    return {};
}

Checked<Answer> runScan(const Call &call)
{
    if (call.bus == nullptr && call.arguments.has("--save"))
        return badInput(
            QStringLiteral("notOnSerialLine"),
            CommandLine::tr("What is found on a serial line is not saved as a project. Leave --save out."));
    if (call.bus == nullptr)
        return scanLine(call);
    if (const auto isFree = checkProjectIsFree(call.arguments); !isFree)
        return tl::unexpected(isFree.error());
    Answer answer = scanRing(call);
    if (call.line != nullptr)
        if (const auto added = addLine(call, answer); !added)
            return tl::unexpected(added.error());
    saveFound(call, answer);
    return answer;
}

} // namespace

const Subcommand scanCommand{
    .name = "scan",
    .usage = "[--save FILE] [--yes] [--all-rates] [--master] [--first ADDRESS] [--last ADDRESS]",
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
                          "--save makes a project of it. With --project as well, what that project "
                          "knows of devices\nthat are still there is taken along."),
    .examples = scanExamples,
    .options = scanOptions,
    .minimumArguments = 0,
    .maximumArguments = 0,
    .needsBus = true,
    .run = runScan,
};

} // namespace codewheel
