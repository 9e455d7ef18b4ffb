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

namespace codewheel {
namespace {

constexpr const char *compareExamples[] = {"compare docs/examples/crane.codewheel"};

struct Compared
{
    QString text;
    QJsonArray lines;
    int differences = 0;
};

// Of several buses each has its heading.
void compareBus(const Call &call, const Project &project, const BusAccess &access, Compared &all)
{
    const EncoderBus &bus = access.bus();
    const PlannedBus *planned = findBus(project, bus.id());
    const BusKind *kind = planned ? busKind(planned->kind) : nullptr;
    if (kind == nullptr)
        return;
    const PlanRules &rules = kind->planRules();
    const ConnectedBus connected = connectedBus(project, bus);
    const Comparison comparison = rules.compare(project, bus.id(), connected);
    all.differences += differences(comparison);
    const auto devices = devicesOn(project, bus.id());
    TextTable table;
    for (const ComparisonLine &line : comparison) {
        table.add({comparisonKindName(line.kind),
                   rules.comparisonText(line, project, bus.id(), connected, call.catalog)});
        const Participant *wanted = line.configured ? &devices[*line.configured].participant : nullptr;
        const Participant *found = line.connected ? &connected.devices[*line.connected] : nullptr;
        all.lines.append(QJsonObject{{QStringLiteral("bus"), bus.id().number},
                                     {QStringLiteral("busName"), planned->name},
                                     {QStringLiteral("comparison"), comparisonKindKey(line.kind)},
                                     {QStringLiteral("configured"), participantJson(wanted)},
                                     {QStringLiteral("found"), participantJson(found)}});
    }
    if (project.buses.size() > 1)
        all.text +=
            (all.text.isEmpty() ? QString() : QStringLiteral("\n")) + planned->name + QStringLiteral(":\n");
    all.text += table.toString();
}

// What nobody looked at is not the same.
QString notCompared(const Call &call, const Project &project)
{
    QStringList names;
    for (const PlannedBus &bus : project.buses)
        if (call.buses.open(bus.id) == nullptr && !devicesOn(project, bus.id).empty())
            names << bus.name;
    return names.join(QStringLiteral(", "));
}

Checked<Answer> runCompare(const Call &call)
{
    const QString &name = call.arguments.rest.front();
    const std::vector<ProjectDevice> planned = devicesOfLink(call, *call.named);
    if (planned.empty() && call.buses.open().empty())
        return tl::unexpected(complaintAbout({RefusalKind::badInput, RefusalId::projectEmpty, {}}));
    if (const auto looked = contactAll(call, planned, &BusAccess::lookFor); !looked)
        return tl::unexpected(looked.error());
    Compared all;
    for (const BusAccess *bus : call.links)
        if (bus->bus().isOpen())
            compareBus(call, *call.named, *bus, all);
    Answer answer{all.text, {{QStringLiteral("lines"), all.lines}}};
    if (const QString others = notCompared(call, *call.named); all.differences == 0 && !others.isEmpty())
        answer.complaint =
            Complaint{ExitCode::refused,
                      QStringLiteral("notAllCompared"),
                      sentence(CommandLine::tr("Not compared, since the link does not lead there, or it "
                                               "cannot be reached: %1."),
                               {others}),
                      {others}};
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
