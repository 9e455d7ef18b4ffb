// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/json.h"
#include "cli/places.h"
#include "cli/ring/ring_access.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "encoder/sentence.h"
#include "project/project_file.h"
#include "project/project_take_over.h"
#include "project/ring_plan.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr const char *compareExamples[] = {"compare docs/examples/crane.codewheel"};

// The device a line has on one side, or nothing.
const Participant *sideOf(const RingStructure &ring, std::optional<std::size_t> index)
{
    return index ? &ring.at(*index) : nullptr;
}

Answer answerOf(const Comparison &comparison, const RingStructure &configured, const RingStructure &connected,
                const Catalog &catalog)
{
    TextTable table;
    QJsonArray lines;
    for (const ComparisonLine &line : comparison) {
        table.add({comparisonKindName(line.kind), comparisonText(line, configured, connected, catalog)});
        lines.append(
            QJsonObject{{QStringLiteral("comparison"), comparisonKindKey(line.kind)},
                        {QStringLiteral("configured"), participantJson(sideOf(configured, line.configured))},
                        {QStringLiteral("found"), participantJson(sideOf(connected, line.connected))}});
    }
    return Answer{table.toString(), {{QStringLiteral("lines"), lines}}};
}

Checked<Answer> runCompare(const Call &call)
{
    const QString &name = call.arguments.rest.front();
    const auto project = loadProject(name);
    if (!project)
        return tl::unexpected(complaintAbout(project.error()));
    const auto bus = busMeant(call, QString::fromLatin1(interbusKind));
    if (!bus)
        return tl::unexpected(bus.error());
    const RingStructure configured = structureOf(*project, (*bus)->bus().id());
    const RingStructure &connected = static_cast<RingAccess &>(**bus).ring().structure();
    const Comparison comparison = compareRings(configured, connected);
    Answer answer = answerOf(comparison, configured, connected, call.catalog);
    const auto differences = std::ranges::count_if(
        comparison, [](const ComparisonLine &line) { return line.kind != ComparisonKind::same; });
    if (differences > 0)
        answer.complaint =
            Complaint{ExitCode::refused,
                      QStringLiteral("busDiffers"),
                      sentence(CommandLine::tr("The bus differs from %1. Lines that differ: %2."),
                               {name, QString::number(differences)}),
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
        "make is not compared: the bus does not tell it.\nSends nothing."),
    .examples = compareExamples,
    .options = {},
    .minimumArguments = 1,
    .maximumArguments = 1,
    .needsBus = true,
    .run = runCompare,
};

} // namespace codewheel
