// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure_editor/plan_edits.h"

#include "project/bus_kind.h"
#include "project/bus_plans.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The context of these texts.
struct StructureSteps
{
    Q_DECLARE_TR_FUNCTIONS(StructureSteps)
};

} // namespace

void PlanEdits::setBus(BusId bus, const QString &kind)
{
    m_bus = bus;
    m_kind = kind;
}

QString PlanEdits::kindKey() const
{
    const PlannedBus *planned = findBus(project(), m_bus);
    return planned ? planned->kind : m_kind;
}

const BusKind *PlanEdits::kind() const
{
    return busKind(kindKey());
}

const PlanRules &PlanEdits::rules() const
{
    static const PlanRules none;
    return kind() ? kind()->planRules() : none;
}

std::vector<PlanRow> PlanEdits::rows() const
{
    return rules().rows(project(), m_bus, m_catalog);
}

std::vector<std::size_t> PlanEdits::indicesOf(const Ids &devices) const
{
    std::vector<std::size_t> indices;
    for (const Id device : devices)
        if (const auto index = m_document.indexOf(device))
            indices.push_back(*index);
    return indices;
}

Result<void> PlanEdits::apply(Result<EditedPlan> edited, const QString &what)
{
    if (!edited)
        return tl::unexpected(edited.error());
    Project after = project();
    planBus(after, m_bus, *kind());
    setDevicesOn(after, m_bus, std::move(edited->devices));
    m_document.edit(std::move(after), m_bus, edited->from, what);
    return {};
}

Result<PlanEdits::Id> PlanEdits::insert(const Participant &device, const KindData &where)
{
    const BusId bus = m_bus; // who hears of the edit may choose another one
    const auto edited = rules().insert(project(), bus, device, where);
    if (const auto done = apply(edited, StructureSteps::tr("Insert %1").arg(nameOf(device))); !done)
        return tl::unexpected(done.error());
    const auto at =
        std::ranges::find_if(edited->from, [](const auto &from) { return !from; }) - edited->from.begin();
    return m_document.ids(bus)[static_cast<std::size_t>(at)];
}

Result<void> PlanEdits::remove(const Ids &devices)
{
    if (devices.empty())
        return {};
    const QString what = devices.size() == 1 ? StructureSteps::tr("Remove %1").arg(placeOf(devices.front()))
                                             : StructureSteps::tr("Remove %n devices", nullptr,
                                                                  static_cast<int>(devices.size()));
    return apply(rules().remove(project(), m_bus, indicesOf(devices)), what);
}

Result<void> PlanEdits::move(const Ids &devices, const KindData &where)
{
    if (devices.empty())
        return {};
    const QString what = devices.size() == 1 ? StructureSteps::tr("Move %1").arg(placeOf(devices.front()))
                                             : StructureSteps::tr("Move %n devices", nullptr,
                                                                  static_cast<int>(devices.size()));
    return apply(rules().move(project(), m_bus, indicesOf(devices), where), what);
}

Result<void> PlanEdits::move(Id device, PlanStep step)
{
    const auto where = rules().stepped(project(), m_bus, *m_document.indexOf(device), step);
    return where ? move({device}, *where) : Result<void>();
}

Result<void> PlanEdits::drop(const Ids &devices, std::optional<Id> parent, int row)
{
    if (devices.empty())
        return {};
    const auto where = rules().dropped(project(), m_bus, *m_document.indexOf(devices.front()),
                                       parent ? m_document.indexOf(*parent) : std::nullopt, row);
    return where ? move(devices, *where) : Result<void>();
}

Result<void> PlanEdits::change(Id device, const Participant &to)
{
    return apply(rules().change(project(), m_bus, *m_document.indexOf(device), to),
                 StructureSteps::tr("Change %1 to %2").arg(placeOf(device), nameOf(to)));
}

void PlanEdits::takeOver(const ConnectedBus &connected, const Comparison &comparison,
                         std::span<const std::size_t> lines, const QString &what)
{
    (void)apply(rules().takenOver(project(), m_bus, connected, comparison, lines), what);
}

Result<void> PlanEdits::type(Id device, const PlanColumn &column, const QString &text)
{
    const Place place = m_document.device(device)->place();
    return apply(rules().type(project(), place, column, text),
                 StructureSteps::tr("%1 of %2", "column, device").arg(column.title, place.toString()));
}

} // namespace codewheel
