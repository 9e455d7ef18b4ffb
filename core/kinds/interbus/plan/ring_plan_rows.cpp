// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown of a planned ring, and what is typed into it: addresses in the process image.
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "kinds/interbus/plan/check_project.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/plan/ring_plan_rules.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/ring_tree.h"

#include <QLocale>

namespace codewheel {
namespace {

// The columns of a ring.
constexpr std::size_t inColumn = 3;

// The translation context of these texts.
struct AddressText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingPlanRules)
};

const DeviceDescription *descriptionOf(const RingDevice &participant, const Catalog &catalog)
{
    const DeviceDescription *named = catalog.find(participant.deviceKey);
    return named ? named : catalog.generic(participant.deviceCode);
}

AddressRules::Unit unitOf(const Project &project, BusId ring)
{
    return ringPlan(project, ring).addresses.unit;
}

QString idCodeCell(const RingDevice &device)
{
    return QStringLiteral("%1 = %2").arg(hexCode(device.idCode(), 2)).arg(device.idCode());
}

// In words, an odd byte is shown as "6 + 1", and typed without the "+ 1".
QString typedAddress(const QString &shown)
{
    return shown.section(u' ', 0, 0);
}

PlanCell addressCell(const std::optional<AddressRange> &range, AddressRules::Unit unit)
{
    if (!range)
        return {.text = {}, .toolTip = AddressText::tr("It has no such words."), .typed = {}};
    const QString text = addressText(range->first, unit);
    const QString bytes = AddressText::tr("Bytes %1 to %2").arg(range->first).arg(range->last());
    const QString how = range->byHand
                            ? AddressText::tr("Given by hand. Delete the number to have it counted again.")
                            : AddressText::tr("Counted in ring order. Type a number to give it by hand.");
    return {.text = text, .toolTip = bytes + u'\n' + how, .typed = typedAddress(text)};
}

} // namespace

QString RingPlanRules::nameOf(const Participant &device, const Catalog &catalog) const
{
    const RingDevice its = ringDevice(device);
    return ringDeviceName(its, descriptionOf(its, catalog));
}

QString RingPlanRules::codeOf(const Participant &device) const
{
    const unsigned code = ringDevice(device).idCode();
    return code == 0 ? QString() : hexCode(code, 2);
}

QString RingPlanRules::reading(const Participant &device, const Catalog &catalog) const
{
    const RingDevice its = ringDevice(device);
    return tr("%1: %2, words: IN %3, OUT %4")
        .arg(hexCode(device.deviceCode, 4), nameOf(device, catalog))
        .arg(its.inWords)
        .arg(its.outWords);
}

std::vector<PlanColumn> RingPlanRules::ownColumns(const Project &project, BusId ring) const
{
    const bool inBytes = unitOf(project, ring) == AddressRules::Unit::byte;
    const auto column = [](const QString &title, bool isNumber = false) {
        return PlanColumn{.field = PlanField::own, .title = title, .own = 0, .isNumber = isNumber};
    };
    return {column(tr("Profile")), column(tr("ID code")), column(tr("Words IN / OUT")),
            column(inBytes ? tr("IN byte") : tr("IN word"), true),
            column(inBytes ? tr("OUT byte") : tr("OUT word"), true)};
}

std::vector<Finding> RingPlanRules::complete(std::vector<PlanRow> &rows, const Project &project, BusId ring,
                                             const Catalog &catalog) const
{
    const std::vector<DeviceAddresses> addresses = processAddresses(project, ring);
    const AddressRules::Unit unit = unitOf(project, ring);
    const RingStructure structure = structureOf(project, ring);
    const RingTree tree = ringTree(structure);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const RingDevice &device = structure[i];
        const DeviceDescription *described = descriptionOf(device, catalog);
        PlanRow &row = rows[i];
        row.parent = tree.nodes[i].parent;
        row.isCoupler = device.idCode() == busTerminalIdCode;
        row.codes = {hexCode(device.idCode(), 2), hexCode(device.deviceCode, 4)};
        row.toolTip += u'\n' + tr("ID code %1, device code %2\nWords: IN %3, OUT %4")
                                   .arg(idCodeCell(device), row.codes.back())
                                   .arg(device.inWords)
                                   .arg(device.outWords);
        row.own = {
            {.text = described ? profileName(described->profile) : QString(), .toolTip = {}, .typed = {}},
            {.text = idCodeCell(device), .toolTip = {}, .typed = {}},
            {.text = QStringLiteral("%1 / %2").arg(device.inWords).arg(device.outWords),
             .toolTip = {},
             .typed = {}},
            addressCell(addresses[i].in, unit),
            addressCell(addresses[i].out, unit)};
    }
    return checkProject(project, addresses, ring);
}

std::vector<Finding> RingPlanRules::check(const Project &project, BusId ring) const
{
    return checkProject(project, processAddresses(project, ring), ring);
}

QString RingPlanRules::complaint(const Project &project, Place device, const PlanColumn &column,
                                 const QString &text) const
{
    const AddressRules::Unit unit = unitOf(project, device.bus);
    if (column.field != PlanField::own || text.isEmpty() || parseAddress(text, unit))
        return {};
    const int largest = unit == AddressRules::Unit::byte ? largestAddress : largestAddress / 2;
    return tr("%1 is not an address. Give a number from 0 to %2, or nothing to have it counted.")
        .arg(text, QLocale().toString(largest));
}

Result<EditedPlan> RingPlanRules::type(const Project &project, Place device, const PlanColumn &column,
                                       const QString &text) const
{
    if (column.field != PlanField::own)
        return PlanRules::type(project, device, column, text);
    EditedPlan after = unchanged(project, device.bus);
    const auto edited = std::ranges::find(after.devices, device, &ProjectDevice::place);
    const auto index = static_cast<std::size_t>(edited - after.devices.begin());
    const AddressRules::Unit unit = unitOf(project, device.bus);
    const auto given = parseAddress(text, unit);
    const bool isIn = column.own == inColumn;
    const DeviceAddresses addresses = processAddresses(project, device.bus)[index];
    const auto &now = isIn ? addresses.in : addresses.out;
    // What was merely looked at stays automatic.
    const bool isUnchanged =
        now && given && (now->first == *given || typedAddress(addressText(now->first, unit)) == text);
    if (now && !isUnchanged) {
        auto byHand = edited->its<GivenAddresses>();
        (isIn ? byHand.in : byHand.out) = given;
        edited->set(byHand);
    }
    return after;
}

} // namespace codewheel
