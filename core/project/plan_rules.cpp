// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/plan_rules.h"

#include "catalog/catalog.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

// "12" of "esc:12"
QString writtenShort(NodeId node)
{
    return node.toString().section(u':', -1);
}

// Null: another column.
QString *textOf(ProjectDevice &device, PlanField field)
{
    switch (field) {
    case PlanField::station:
        return &device.station;
    case PlanField::group:
        return &device.group;
    case PlanField::serialNumber:
        return &device.label.serialNumber;
    case PlanField::note:
        return &device.note;
    default:
        return nullptr;
    }
}

// By their places.
void putInOrder(EditedPlan &plan)
{
    std::vector<std::size_t> order(plan.devices.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return plan.devices[i].place(); });
    EditedPlan sorted;
    for (const std::size_t i : order) {
        sorted.devices.push_back(std::move(plan.devices[i]));
        sorted.from.push_back(plan.from[i]);
    }
    plan = std::move(sorted);
}

} // namespace

std::vector<PlanColumn> PlanRules::columns(const Project &project, BusId bus) const
{
    std::vector<PlanColumn> columns{{PlanField::place, placeTitle()},
                                    {PlanField::station, tr("Station")},
                                    {PlanField::group, tr("Group")},
                                    {PlanField::device, tr("Device")}};
    for (PlanColumn &own : ownColumns(project, bus)) {
        own.own = columns.size() - 4;
        columns.push_back(std::move(own));
    }
    columns.push_back({PlanField::serialNumber, tr("Serial number")});
    columns.push_back({PlanField::note, tr("Note")});
    columns.push_back({PlanField::findings, tr("Findings")});
    return columns;
}

std::vector<PlanRow> PlanRules::rows(const Project &project, BusId bus, const Catalog &catalog) const
{
    std::vector<PlanRow> rows;
    for (const ProjectDevice &device : devicesOn(project, bus)) {
        PlanRow &row = rows.emplace_back();
        row.place = device.place();
        row.station = device.station;
        row.group = device.group;
        row.note = device.note;
        row.serialNumber = device.label.serialNumber;
        row.name = nameOf(device.participant, catalog);
        row.toolTip = QStringLiteral("%1  %2").arg(row.place.toString(), row.name);
    }
    // The row shows where it is: the number moves on when a device before it is inserted.
    for (Finding &finding : complete(rows, project, bus, catalog)) {
        std::vector<Finding> &its = rows[std::exchange(finding.device, 0)].findings;
        its.push_back(std::move(finding));
    }
    return rows;
}

QString PlanRules::nameOf(const Participant &device, const Catalog &catalog) const
{
    const DeviceDescription *described = catalog.find(device.deviceKey);
    return described ? described->fullName() : device.deviceKey;
}

bool PlanRules::isEditable(const PlanRow &row, const PlanColumn &column) const
{
    switch (column.field) {
    case PlanField::station:
    case PlanField::group:
    case PlanField::note:
        return true;
    case PlanField::serialNumber:
        return !row.isCoupler;
    case PlanField::place:
        return !isOrdered();
    case PlanField::own:
        return row.own.at(column.own).typed.has_value();
    default:
        return false;
    }
}

QString PlanRules::complaint(const Project &project, Place device, const PlanColumn &column,
                             const QString &text) const
{
    if (column.field != PlanField::place)
        return {};
    const auto place = typedPlace(text);
    if (!place)
        return noPlaceText(text);
    std::vector<ProjectDevice> others;
    std::ranges::copy_if(devicesOn(project, device.bus), std::back_inserter(others),
                         [&](const ProjectDevice &other) { return other.place() != device; });
    return whyNotAt(*place, others);
}

Result<EditedPlan> PlanRules::type(const Project &project, Place device, const PlanColumn &column,
                                   const QString &text) const
{
    EditedPlan after = unchanged(project, device.bus);
    ProjectDevice &edited = *std::ranges::find(after.devices, device, &ProjectDevice::place);
    if (QString *its = textOf(edited, column.field))
        *its = text;
    if (column.field == PlanField::place) {
        edited.participant.number = typedPlace(text).value_or(device.node);
        putInOrder(after);
    }
    return after;
}

std::vector<Participant> PlanRules::offered(const Catalog &catalog) const
{
    std::vector<Participant> offered;
    for (const DeviceDescription &device : catalog.devices())
        if (isOffered(device))
            offered.push_back({.number = {}, .deviceKey = device.key});
    return offered;
}

QString PlanRules::reading(const Participant &device, const Catalog &catalog) const
{
    return nameOf(device, catalog);
}

// The place of a chosen device that is not planned comes first, or else the free ones after the chosen one.
std::vector<PlanTarget> PlanRules::targets(const Project &project, BusId bus,
                                           std::optional<std::size_t> chosen,
                                           std::optional<NodeId> connected) const
{
    const Devices devices = devicesOn(project, bus);
    std::vector<NodeId> free;
    for (const NodeId place : places())
        if (whyNotAt(place, devices).isEmpty())
            free.push_back(place);
    if (chosen)
        std::rotate(free.begin(), std::ranges::upper_bound(free, devices[*chosen].place().node), free.end());
    else if (connected)
        std::rotate(free.begin(), std::ranges::lower_bound(free, *connected), free.end());
    std::vector<PlanTarget> targets;
    targets.reserve(free.size());
    for (const NodeId place : free)
        targets.push_back({place.toString(), KindData(place)});
    return targets;
}

Result<EditedPlan> PlanRules::insert(const Project &project, BusId bus, const Participant &device,
                                     const KindData &where) const
{
    const NodeId *place = where.as<NodeId>();
    if (place == nullptr)
        return unchanged(project, bus);
    if (const QString why = whyNotAt(*place, devicesOn(project, bus)); !why.isEmpty())
        return refuse(RefusalKind::badInput, RefusalId::structureBroken, {why});
    EditedPlan after = unchanged(project, bus);
    ProjectDevice &added = after.devices.emplace_back();
    added.participant = device;
    added.standAt({bus, *place});
    after.from.emplace_back();
    putInOrder(after);
    return after;
}

Result<EditedPlan> PlanRules::remove(const Project &project, BusId bus,
                                     std::span<const std::size_t> devices) const
{
    EditedPlan after;
    EditedPlan before = unchanged(project, bus);
    for (std::size_t i = 0; i < before.devices.size(); ++i)
        if (std::ranges::find(devices, i) == devices.end()) {
            after.devices.push_back(std::move(before.devices[i]));
            after.from.emplace_back(i);
        }
    return after;
}

Result<EditedPlan> PlanRules::change(const Project &project, BusId bus, std::size_t device,
                                     const Participant &to) const
{
    EditedPlan after = unchanged(project, bus);
    ProjectDevice &changed = after.devices[device];
    if (changed.participant.deviceKey != to.deviceKey)
        becomeAnother(changed);
    changed.participant = to;
    changed.participant.number = devicesOn(project, bus)[device].participant.number;
    return after;
}

Result<EditedPlan> PlanRules::move(const Project &project, BusId bus, std::span<const std::size_t>,
                                   const KindData &) const
{
    return unchanged(project, bus);
}

EditedPlan PlanRules::unchanged(const Project &project, BusId bus)
{
    const Devices devices = devicesOn(project, bus);
    EditedPlan plan{{devices.begin(), devices.end()}, {}};
    for (std::size_t i = 0; i < devices.size(); ++i)
        plan.from.emplace_back(i);
    return plan;
}

std::optional<NodeId> PlanRules::typedPlace(const QString &text) const
{
    const std::vector<NodeId> all = places();
    const auto found = std::ranges::find_if(all, [&](NodeId place) {
        return text.compare(place.toString(), Qt::CaseInsensitive) == 0 ||
               text.compare(writtenShort(place), Qt::CaseInsensitive) == 0;
    });
    return found == all.end() ? std::nullopt : std::optional(*found);
}

QString PlanRules::noPlaceText(const QString &text) const
{
    const std::vector<NodeId> all = places();
    if (all.empty())
        return tr("Devices of this bus keep their places.");
    return sentence(tr("\"%1\" is not an address of this bus: type one from %2 to %3."),
                    {text, writtenShort(all.front()), writtenShort(all.back())});
}

QString PlanRules::whyNotAt(NodeId place, Devices others) const
{
    const auto there =
        std::ranges::find(others, place, [](const ProjectDevice &other) { return other.place().node; });
    if (there == others.end())
        return {};
    const QString address = writtenShort(place);
    return there->station.isEmpty() ? sentence(tr("Another device is planned at %1."), {address})
                                    : sentence(tr("\"%2\" is planned at %1."), {address, there->station});
}

void becomeAnother(ProjectDevice &device)
{
    device.label = {};
    device.wanted.clear();
    device.wantedCams.clear();
    device.stored.clear();
    device.storedCams.clear();
    device.lastPosition.reset();
}

} // namespace codewheel
