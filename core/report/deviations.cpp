// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/deviations.h"

#include "project/bus_kind.h"
#include "project/old_devices.h"
#include "report/report_words.h"
#include "vocabulary/refusal_text.h"

namespace codewheel {
namespace {

void addDifferences(Deviations &found, const CamProgram &wanted, const StoredCams &known)
{
    for (std::size_t i = 0; i < allCamFieldCount; ++i)
        if (valueOf(wanted, camField(i)) != valueOf(known.program, camField(i)))
            found.cams.push_back({wanted.number, camField(i), valueOf(wanted, camField(i)),
                                  valueOf(known.program, camField(i)), known.evidence});
}

QStringList differencesOf(const Project &project, const PlannedBus &bus, const ConnectedBus &connected,
                          const Catalog &catalog)
{
    const BusKind *kind = busKind(bus.kind);
    if (kind == nullptr)
        return {};
    const PlanRules &rules = kind->planRules();
    const Comparison comparison = rules.compare(project, bus.id, connected);
    QStringList lines;
    if (areSame(comparison))
        return lines;
    const auto uncertain = rules.uncertain(project, bus.id, connected, catalog);
    for (const ComparisonLine &line : comparison) {
        const bool isSame = line.kind == ComparisonKind::same;
        const NodeId node =
            isSame ? devicesOn(project, bus.id)[*line.configured].participant.number : NodeId();
        const auto why = uncertain.find(node);
        const bool isUncertain = isSame && why != uncertain.end();
        if (isUncertain && node == connected.devices[*line.connected].number)
            lines << refusalText(why->second); // what is known of it is not reported
        else if (isUncertain || !isSame)
            lines << rules.comparisonText(line, project, bus.id, connected, catalog);
    }
    return lines;
}

} // namespace

Deviations deviationsOf(const ReportedDevice &device)
{
    Deviations found;
    for (const ParameterValue &wanted : device.planned->wanted) {
        const StoredValue *known = device.known(wanted.parameter);
        if (!known)
            ++found.notKnown;
        else if (known->value != wanted.value)
            found.values.push_back({wanted.parameter, wanted.value, *known});
    }
    for (const CamProgram &wanted : device.planned->wantedCams) {
        if (const StoredCams *known = device.knownCams(wanted.number))
            addDifferences(found, wanted, *known);
        else
            ++found.notKnown;
    }
    return found;
}

DeviationCounts countDeviations(const std::vector<ReportedDevice> &devices)
{
    DeviationCounts counts;
    for (const ReportedDevice &device : devices) {
        const Deviations found = deviationsOf(device);
        counts.deviations += static_cast<int>(found.count());
        counts.notKnown += found.notKnown;
    }
    return counts;
}

std::int64_t BusComparisons::differences() const
{
    std::int64_t all = 0;
    for (const auto &[bus, its] : lines)
        all += its.size();
    return all;
}

BusComparisons busComparisons(const ReportInput &input, const Catalog &catalog)
{
    BusComparisons all;
    for (const PlannedBus &bus : input.project.buses) {
        const auto connected = input.connected.find(bus.id);
        if (connected != input.connected.end()) {
            all.lines.emplace_back(bus.name, differencesOf(input.project, bus, connected->second, catalog));
            for (const OldDevices &devices : oldDevices(connected->second))
                all.old << QStringLiteral("%1: %2").arg(
                    bus.name, withPlaces(devices, report_words::lastSeen(devices.old, input.now)));
        } else if (!devicesOn(input.project, bus.id).empty())
            all.notCompared << bus.name;
    }
    return all;
}

} // namespace codewheel
