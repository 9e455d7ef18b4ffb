// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/bus_kind.h"
#include "project/ring_plan_rules.h"

#include <QCoreApplication>

namespace codewheel {

// A ring as projects have it (ring_plan.h).
class RingKind final : public BusKind
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingKind)

public:
    QString key() const override;
    QString title() const override;
    QString usualName() const override;
    std::optional<BusId> trainingBus() const override { return firstRing; }
    KindData usual() const override;
    QString linkText(const KindData &settings) const override;
    std::unique_ptr<BusOutline> outline(const Project &project, BusId bus,
                                        const Catalog &catalog) const override;
    KindData read(const JsonObject &json, std::vector<ProjectDevice> &devices) const override;
    void write(ProjectWriter &writer, const KindData &settings,
               std::span<const ProjectDevice> devices) const override;
    std::vector<Finding> check(const Project &project, BusId bus) const override;
    const PlanRules &planRules() const override { return m_planRules; }

private:
    RingPlanRules m_planRules;
};

} // namespace codewheel
