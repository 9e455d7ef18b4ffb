// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/deviations.h"

#include "encoder/refusal_text.h"
#include "project/project_take_over.h"
#include "ring/ring_strangers.h"

namespace codewheel {
namespace {

void addDifferences(Deviations &found, const CamProgram &wanted, const StoredCams &known)
{
    const CamFieldSet differ = differences(wanted, known.program);
    for (std::size_t i = 0; i < camFieldCount; ++i)
        if (differ[i])
            found.cams.push_back({wanted.number, camField(i), valueOf(wanted, camField(i)),
                                  valueOf(known.program, camField(i)), known.evidence});
}

QStringList ringDifferences(const RingStructure &configured, const RingStructure &connected,
                            const Catalog &catalog)
{
    const Comparison comparison = compareRings(configured, connected);
    QStringList lines;
    if (areSame(comparison))
        return lines;
    const auto strangers = strangersInRing(configured, connected, catalog);
    for (const ComparisonLine &line : comparison) {
        const bool isSame = line.kind == ComparisonKind::same;
        const auto why = isSame ? strangers.find(configured[*line.configured].number) : strangers.end();
        const bool isStranger = why != strangers.end();
        const bool hasItsNumber =
            isSame && configured[*line.configured].number == connected[*line.connected].number;
        if (isStranger && hasItsNumber)
            lines << refusalText(why->second); // nothing known of it is reported
        else if (isStranger || !isSame)
            lines << comparisonText(line, configured, connected, catalog);
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

std::optional<QStringList> busDifferences(const ReportInput &input, const Catalog &catalog)
{
    if (!input.connected && !input.strangers)
        return std::nullopt;
    QStringList lines;
    if (input.connected)
        lines = ringDifferences(structureOf(input.project), *input.connected, catalog);
    for (const Refusal &why : input.strangers.value_or(std::vector<Refusal>()))
        lines << refusalText(why);
    return lines;
}

} // namespace codewheel
