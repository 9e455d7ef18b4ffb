// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/bus_kind.h"
#include "project/line_plan_rules.h"

#include <QCoreApplication>

namespace codewheel {

// A serial line as projects have it (line_plan.h).
class LineKind final : public BusKind
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::LineKind)

public:
    QString key() const override;
    QString title() const override;
    QString usualName() const override;
    std::optional<BusId> trainingBus() const override { return firstLine; }
    KindData usual() const override;
    QString linkText(const KindData &settings) const override;
    std::unique_ptr<BusOutline> outline(const Project &project, BusId bus,
                                        const Catalog &catalog) const override;
    KindData read(const JsonObject &json, std::vector<ProjectDevice> &devices) const override;
    void write(ProjectWriter &writer, const KindData &settings,
               std::span<const ProjectDevice> devices) const override;
    const PlanRules &planRules() const override { return m_planRules; }

private:
    LinePlanRules m_planRules;
};

} // namespace codewheel
