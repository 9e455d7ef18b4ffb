// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/buses.h"
#include "cli/bus/bus_access.h"
#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/project/project_of_call.h"
#include "cli/project/transfer_call.h"
#include "project/bus_kind.h"
#include "project/plan_rules.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

constexpr const char *compareExamples[] = {"compare docs/examples/crane.codewheel"};

struct Compared
{
    QString text;
    QJsonArray lines;
    int differences = 0;
};

// With several buses each gets a heading.
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
        const auto json = [&](const Participant *device) {
            return device != nullptr ? QJsonValue(access.participantJson(*device)) : QJsonValue();
        };
        const Participant *wanted = line.configured ? &devices[*line.configured].participant : nullptr;
        const Participant *found = line.connected ? &connected.devices[*line.connected] : nullptr;
        QJsonObject row{{QStringLiteral("bus"), bus.id().number},
                        {QStringLiteral("busName"), planned->name},
                        {QStringLiteral("comparison"), comparisonKindKey(line.kind)},
                        {QStringLiteral("configured"), json(wanted)},
                        {QStringLiteral("found"), json(found)}};
        if (const auto why = found != nullptr ? connected.others.find(found->number) : connected.others.end();
            why != connected.others.end())
            row.insert(QStringLiteral("why"), errorJson(complaintAbout(why->second)));
        all.lines.append(row);
    }
    if (project.buses.size() > 1)
        all.text +=
            (all.text.isEmpty() ? QString() : QStringLiteral("\n")) + planned->name + QStringLiteral(":\n");
    all.text += table.toString();
}

// What nobody looked at is not the same.
QStringList notCompared(const Call &call, const Project &project, const std::set<BusId> &gone)
{
    QStringList names;
    for (const PlannedBus &bus : project.buses) {
        const bool isThere = call.buses.open(bus.id) != nullptr && !gone.contains(bus.id);
        if (!isThere && !devicesOn(project, bus.id).empty())
            names << bus.name;
    }
    return names;
}

std::optional<Complaint> complaintAboutAll(const QString &project, int differences, const QStringList &others)
{
    const QString names = others.join(QStringLiteral(", "));
    const QString left = others.isEmpty()
                             ? QString()
                             : sentence(CommandLine::tr("Not compared, since the link does not lead there, "
                                                        "or it cannot be reached: %1."),
                                        {names});
    if (differences > 0)
        return notDone("busDiffers",
                       (sentence(CommandLine::tr("The bus differs from %1. Lines that differ: %2."),
                                 {project, QString::number(differences)}) +
                        u' ' + left)
                           .trimmed(),
                       {project});
    if (!others.isEmpty())
        return notDone("notAllCompared", left, {names});
    return std::nullopt;
}

Checked<Answer> runCompare(const Call &call)
{
    const QString &name = call.arguments.rest.front();
    const std::vector<ProjectDevice> planned = devicesOfLink(call, *call.named);
    if (planned.empty() && call.buses.open().empty())
        return tl::unexpected(complaintAbout({RefusalKind::badInput, RefusalId::projectEmpty, {}}));
    nameBuses(call, *call.named);
    const auto gone = contactAll(call, planned, &BusAccess::lookFor);
    if (!gone)
        return tl::unexpected(gone.error());
    Compared all;
    for (const BusAccess *bus : call.links)
        if (bus->bus().isOpen() && !gone->contains(bus->bus().id()))
            compareBus(call, *call.named, *bus, all);
    const QStringList others = notCompared(call, *call.named, *gone);
    Answer answer{all.text,
                  {{QStringLiteral("lines"), all.lines},
                   {QStringLiteral("notCompared"), QJsonArray::fromStringList(others)}}};
    answer.complaint = complaintAboutAll(name, all.differences, others);
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
    .arguments = {1},
    .needsBus = true,
    .namesProject = true,
    .run = runCompare,
};

} // namespace codewheel
