// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/bus_branch.h"

#include "widgets/project/project_document.h"

#include <algorithm>

namespace codewheel {

QString BusBranch::modeNow() const
{
    if (connected == nullptr || !connected->isOpen() || connected->isReplay())
        return {};
    return connected->isOperating() ? QCoreApplication::translate("codewheel::BusBranch", "Operate")
                                    : QCoreApplication::translate("codewheel::BusBranch", "Watch");
}

std::optional<std::size_t> BusBranch::find(NodeId node) const
{
    const auto found = std::ranges::find(rows, node, [](const Row &row) { return row.node.node; });
    return found == rows.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - rows.begin()));
}

const std::vector<std::size_t> &BusBranch::siblings(const Row &row) const
{
    return row.node.parent ? rows[*row.node.parent].children : top;
}

void BusBranch::arrange()
{
    top.clear();
    for (Row &row : rows)
        row.children.clear();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        auto &beside = rows[i].node.parent ? rows[*rows[i].node.parent].children : top;
        rows[i].place = beside.size();
        beside.push_back(i);
    }
}

BusBranch::Row BusBranch::make(quintptr rowId, std::size_t node, const BusNode &what,
                               const ProjectDocument *project) const
{
    return {.id = rowId,
            .node = what,
            .station = stationOf(what, project),
            .isOther = isOther(what, project),
            .state = outline().state(node),
            .children = {}};
}

// If another kind of device is connected, it does not get the planned station.
QString BusBranch::stationOf(const BusNode &node, const ProjectDocument *project) const
{
    if (project == nullptr)
        return {};
    const ProjectDevice &device = project->device({bus, node.node});
    return device.participant.deviceCode == node.deviceCode ? device.station : QString();
}

bool BusBranch::isOther(const BusNode &node, const ProjectDocument *project) const
{
    if (project == nullptr || connected == nullptr)
        return false;
    const unsigned wanted = project->device({bus, node.node}).participant.deviceCode;
    return wanted != 0 && wanted != node.deviceCode;
}

// It may be in order by itself, and yet not what belongs there.
NodeState BusBranch::stateOf(std::size_t row) const
{
    NodeState its = outline().state(row);
    if (rows[row].isOther && its.shown.role == Role::running)
        its.shown = {Role::attention, QCoreApplication::translate("codewheel::BusBranch", "other kind",
                                                                  "of device than planned")};
    return its;
}

QString calledText(const QString &station, const QString &name)
{
    return station.isEmpty()
               ? name
               : QCoreApplication::translate("codewheel::BusBranch", "%1: %2", "station, device")
                     .arg(station, name);
}

} // namespace codewheel
