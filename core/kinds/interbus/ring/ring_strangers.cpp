// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_strangers.h"

#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "kinds/interbus/ring/comparison.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The translation context of these texts.
struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingStrangers)
};

// "FRABA OCD-IB K3", "bus terminal", "0237h"
QString nameOrCode(const RingDevice &participant, const Catalog &catalog)
{
    const DeviceDescription *device = catalog.findFitting(participant.deviceKey, participant.deviceCode);
    return device || participant.idCode() == busTerminalIdCode ? nameOrTerminal(participant, device)
                                                               : hexCode(participant.deviceCode, 4);
}

// The project's device, and what became of it.
QString configuredText(const ComparisonLine &line, const QString &name, const RingDevice *partner)
{
    if (line.kind == ComparisonKind::missing)
        return sentence(Texts::tr("%1 (missing now)"), {name});
    if (line.kind == ComparisonKind::moved && partner != nullptr)
        return sentence(Texts::tr("%1 (moved to %2)"), {name, partner->number.toString()});
    if (line.kind == ComparisonKind::same && partner != nullptr)
        return sentence(Texts::tr("%1 (its number is %2 now)"), {name, partner->number.toString()});
    return name;
}

// For a device that is not certain to be at its place.
Refusal whyNot(const ComparisonLine &line, const RingDevice &configured, const RingStructure &connected,
               const Catalog &catalog)
{
    const auto found = std::ranges::find(connected, configured.number, &RingDevice::number);
    const QString place = configured.number.toString();
    if (found == connected.end())
        return {RefusalKind::link, RingRefusalId::notInRing, {place}};
    const QString name = nameOrCode(configured, catalog);
    const RingDevice *partner = line.connected ? &connected[*line.connected] : nullptr;
    const bool isUncertain =
        line.kind != ComparisonKind::differs && partner && partner->number == configured.number;
    if (isUncertain)
        return {RefusalKind::link,
                RefusalId::ringDiffers,
                {place, name,
                 Texts::tr("perhaps another one: beside it, one of the same kind is missing or additional")}};
    return {RefusalKind::link,
            RefusalId::ringDiffers,
            {place, configuredText(line, name, partner), nameOrCode(*found, catalog)}};
}

} // namespace

std::map<NodeId, Refusal> strangersInRing(const RingStructure &configured, const RingStructure &connected,
                                          const Catalog &catalog)
{
    std::map<NodeId, Refusal> strangers;
    const Comparison comparison = compareRings(configured, connected);
    const Comparison certain = certainLines(comparison, configured, connected);
    for (const ComparisonLine &line : comparison) {
        if (!line.configured)
            continue;
        const RingDevice &planned = configured[*line.configured];
        const bool isThere = std::ranges::find(certain, line) != certain.end() &&
                             connected[*line.connected].number == planned.number;
        if (!isThere)
            strangers.emplace(planned.number, whyNot(line, planned, connected, catalog));
    }
    return strangers;
}

} // namespace codewheel
