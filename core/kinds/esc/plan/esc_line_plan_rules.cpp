// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/plan/esc_line_plan_rules.h"

#include "catalog/device_description.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/protocol/esc_profile.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {

std::vector<Finding> EscLinePlanRules::complete(std::vector<PlanRow> &rows, const Project &, BusId,
                                                const Catalog &) const
{
    for (PlanRow &row : rows)
        row.toolTip += u'\n' + sentence(tr("Address %1"), {EscLineAddress::of(row.place.node).shown()});
    return {};
}

std::vector<NodeId> EscLinePlanRules::places() const
{
    std::vector<NodeId> places;
    for (std::uint8_t address = 1; address <= EscLineAddress::last; ++address)
        places.push_back(EscLineAddress{address}.node());
    return places;
}

std::optional<NodeId> EscLinePlanRules::typedPlace(const QString &text) const
{
    const auto address = addressTyped(text);
    return address ? std::optional(address->node()) : std::nullopt;
}

QString EscLinePlanRules::noPlaceText(const QString &text) const
{
    return refusalText({RefusalKind::badInput, EscRefusalId::lineAddressWrong, {text}});
}

QString EscLinePlanRules::whyNotAt(NodeId place, Devices others) const
{
    const auto address = [](NodeId node) { return EscLineAddress::of(node); };
    const bool isOtherMaster = std::ranges::any_of(
        others, [&](const ProjectDevice &other) { return address(other.place().node).isMaster(); });
    if (others.empty() || !(address(place).isMaster() || isOtherMaster))
        return PlanRules::whyNotAt(place, others);
    const NodeId beside = isOtherMaster ? place : others.front().place().node;
    return refusalText({RefusalKind::badInput,
                        EscRefusalId::lineAddressNotAlone,
                        {EscLineAddress::master().onWire(), address(beside).onWire()}});
}

bool EscLinePlanRules::isOffered(const DeviceDescription &device) const
{
    return device.profile == profile::esc;
}

} // namespace codewheel
