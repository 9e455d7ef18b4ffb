// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/buses.h"
#include "cli/bus_access.h"
#include "cli/commands.h"
#include "cli/json.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "cli/transfer_call.h"
#include "encoder/sentence.h"
#include "project/bus_kind.h"
#include "project/plan_rules.h"
#include "project/project_file.h"

namespace codewheel {
namespace {

constexpr const char *compareExamples[] = {"compare docs/examples/crane.codewheel"};

struct Compared
{
    TextTable table;
    QJsonArray lines;
    int differences = 0;
};

void compareBus(const Project &project, const EncoderBus &bus, const Catalog &catalog, Compared &all)
{
    const PlannedBus *planned = findBus(project, bus.id());
    const BusKind *kind = planned ? busKind(planned->kind) : nullptr;
    if (kind == nullptr)
        return;
    const PlanRules &rules = kind->planRules();
    const ConnectedBus connected = connectedBus(project, bus);
    const Comparison comparison = rules.compare(project, bus.id(), connected);
    all.differences += differences(comparison);
    const auto devices = devicesOn(project, bus.id());
    for (const ComparisonLine &line : comparison) {
        all.table.add({comparisonKindName(line.kind),
                       rules.comparisonText(line, project, bus.id(), connected, catalog)});
        const Participant *wanted = line.configured ? &devices[*line.configured].participant : nullptr;
        const Participant *found = line.connected ? &connected.devices[*line.connected] : nullptr;
        all.lines.append(QJsonObject{{QStringLiteral("bus"), bus.id().number},
                                     {QStringLiteral("comparison"), comparisonKindKey(line.kind)},
                                     {QStringLiteral("configured"), participantJson(wanted)},
                                     {QStringLiteral("found"), participantJson(found)}});
    }
}

// What nobody looked at is not the same.
void tellOthers(const Call &call, const Project &project)
{
    for (const PlannedBus &bus : project.buses)
        if (call.findBus(bus.id) == nullptr && !devicesOn(project, bus.id).empty())
            call.terminal.complain(sentence(
                CommandLine::tr("\"%1\" of the project is not compared: the link does not lead there."),
                {bus.name}));
}

Checked<Answer> runCompare(const Call &call)
{
    const QString &name = call.arguments.rest.front();
    const auto project = loadProject(name);
    if (!project)
        return tl::unexpected(complaintAbout(project.error()));
    const std::vector<ProjectDevice> planned = devicesOfLink(call, *project);
    if (planned.empty() && call.buses.open().empty())
        return tl::unexpected(complaintAbout({RefusalKind::badInput, RefusalId::projectEmpty, {}}));
    for (const ProjectDevice &device : planned)
        if (const auto looked = call.busOf(device.place()).lookFor(call, device); !looked)
            return tl::unexpected(looked.error());
    tellOthers(call, *project);
    Compared all;
    for (const EncoderBus *bus : call.buses.open())
        compareBus(*project, *bus, call.catalog, all);
    Answer answer{all.table.toString(), {{QStringLiteral("lines"), all.lines}}};
    if (all.differences > 0)
        answer.complaint =
            Complaint{ExitCode::refused,
                      QStringLiteral("busDiffers"),
                      sentence(CommandLine::tr("The bus differs from %1. Lines that differ: %2."),
                               {name, QString::number(all.differences)}),
                      {name}};
    return answer;
}

} // namespace

const Subcommand compareCommand{
    .name = "compare",
    .usage = "PROJECT",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "compare a project with the bus"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Lays the devices the project has configured beside those that are connected and tells line by line\n"
        "what is the same, differs, is missing, additional or moved; exit code 1 if anything differs. The\n"
        "make is not compared: the bus does not tell it. On a serial line the encoders of the project are\n"
        "asked who they are; one that does not answer is missing.\nSends nothing to a ring."),
    .examples = compareExamples,
    .options = {},
    .minimumArguments = 1,
    .maximumArguments = 1,
    .needsBus = true,
    .namesProject = true,
    .run = runCompare,
};

} // namespace codewheel
