// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/plan_rules.h"

namespace codewheel {

// How the encoders of a serial line are planned: by their addresses, two hexadecimal digits as on the wire.
class EscLinePlanRules final : public PlanRules
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLinePlanRules)

private:
    std::vector<Finding> complete(std::vector<PlanRow> &rows, const Project &project, BusId line,
                                  const Catalog &catalog) const override;
    std::vector<NodeId> places() const override;
    std::optional<NodeId> typedPlace(const QString &text) const override;
    QString noPlaceText(const QString &text) const override;
    QString whyNotAt(NodeId place, Devices others) const override;
    bool isOffered(const DeviceDescription &device) const override;
};

} // namespace codewheel
