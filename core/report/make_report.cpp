// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/make_report.h"

#include "project/bus_kind.h"
#include "report/bus_sections.h"
#include "report/deviations.h"
#include "report/report_words.h"
#include "report/sections.h"
#include "report/texts.h"
#include "vocabulary/local_time.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <iterator>

namespace codewheel {
namespace {

// One for each bus, by its name if there are several.
void addLinks(ReportFacts &facts, const Project &project)
{
    for (const PlannedBus &bus : project.buses)
        if (const BusKind *kind = busKind(bus.kind)) {
            const QString link = kind->linkText(bus.settings);
            facts.push_back({ReportTexts::tr("Link"), project.buses.size() == 1
                                                          ? link
                                                          : QStringLiteral("%1: %2").arg(bus.name, link)});
        }
}

QString busText(const ReportInput &input, const Catalog &catalog)
{
    const BusComparisons compared = busComparisons(input, catalog);
    if (compared.lines.empty())
        return ReportTexts::tr("not compared with a connected one");
    const std::int64_t differences = compared.differences();
    const QString found =
        differences == 0 ? ReportTexts::tr("connected as configured")
                         : sentence(ReportTexts::tr("not connected as configured; lines that differ: %1"),
                                    {numberText(differences)});
    const QString result =
        compared.old.isEmpty() ? found : sentence(ReportTexts::tr("%1 (not up to date)", "result"), {found});
    return compared.notCompared.isEmpty()
               ? result
               : sentence(ReportTexts::tr("%1; not compared: %2", "result, names of buses"),
                          {result, compared.notCompared.join(QStringLiteral(", "))});
}

ReportFacts factsOf(const ReportInput &input, const Catalog &catalog,
                    const std::vector<ReportedDevice> &devices, const QString &program)
{
    const auto encoders = std::ranges::count_if(
        devices, [](const ReportedDevice &each) { return each.description != nullptr; });

    ReportFacts facts;
    const auto add = [&](const QString &name, const QString &text) { facts.push_back({name, text}); };
    add(ReportTexts::tr("Project"),
        input.project.title.isEmpty() ? ReportTexts::tr("without a title") : input.project.title);
    if (!input.file.isEmpty())
        add(ReportTexts::tr("File"), input.file);
    add(ReportTexts::tr("Date"),
        QStringLiteral("%1 (UTC%2)").arg(report_words::time(input.now, input.now), offsetText(input.now)));
    add(ReportTexts::tr("Program"), program);
    addLinks(facts, input.project);
    add(ReportTexts::tr("Devices"),
        sentence(ReportTexts::tr("%1, encoders among them: %2"),
                 {numberText(static_cast<std::int64_t>(devices.size())), numberText(encoders)}));
    add(ReportTexts::tr("Deviations of encoders"), numberText(countDeviations(devices).deviations));
    add(ReportTexts::tr("Bus"), busText(input, catalog));
    return facts;
}

} // namespace

Report makeReport(const ReportInput &input, const Catalog &catalog)
{
    const std::vector<ReportedDevice> devices = reportedDevices(input, catalog);
    const QString program = QStringLiteral("Codewheel %1").arg(input.version);
    Report report{.language = QCoreApplication::translate("DeviceDescription", "en",
                                                          "code of the language of these texts"),
                  .title = ReportTexts::tr("Commissioning report"),
                  .subject = input.project.title,
                  .origin = QStringLiteral("%1, %2").arg(program, report_words::time(input.now, input.now)),
                  .facts = factsOf(input, catalog, devices, program),
                  .sections = {report_sections::deviations(input, catalog, devices),
                               report_sections::structure(input, devices)}};
    for (const PlannedBus &bus : input.project.buses)
        if (const auto more = report_sections::sectionsOf(bus).more;
            more != nullptr && !devicesOn(input.project, bus.id).empty())
            report.sections.push_back(more(input.project, bus.id));
    std::ranges::move(report_sections::encoders(input, devices), std::back_inserter(report.sections));
    report.sections.push_back(report_sections::eepromWrites(input, devices));
    if (ReportSection notes = report_sections::notes(input, devices); !notes.blocks.empty())
        report.sections.push_back(std::move(notes));
    report.sections.push_back(report_sections::signatures());
    return report;
}

} // namespace codewheel
