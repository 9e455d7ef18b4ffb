// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_edit.h"
#include "project/plan_rules.h"

namespace codewheel {

// How a ring is planned: numbers follow from where devices are attached, and a target is a RingPlace.
class RingPlanRules final : public PlanRules
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingPlanRules)

public:
    std::vector<Finding> check(const Project &project, BusId ring) const override;
    QString nameOf(const Participant &device, const Catalog &catalog) const override;
    QString codeOf(const Participant &device) const override;
    bool isOrdered() const override { return true; }
    QString complaint(const Project &project, Place device, const PlanColumn &column,
                      const QString &text) const override;
    Result<EditedPlan> type(const Project &project, Place device, const PlanColumn &column,
                            const QString &text) const override;
    std::vector<Participant> offered(const Catalog &catalog) const override;
    std::optional<Participant> coded(unsigned idCode, unsigned lengthCode) const override;
    QString reading(const Participant &device, const Catalog &catalog) const override;
    std::vector<PlanTarget> targets(const Project &project, BusId ring, std::optional<std::size_t> chosen,
                                    std::optional<NodeId> connected) const override;
    std::size_t preferred(const std::vector<PlanTarget> &targets, const Participant &device,
                          std::size_t target) const override;
    Result<EditedPlan> insert(const Project &project, BusId ring, const Participant &device,
                              const KindData &where) const override;
    Result<EditedPlan> remove(const Project &project, BusId ring,
                              std::span<const std::size_t> devices) const override;
    Result<EditedPlan> change(const Project &project, BusId ring, std::size_t device,
                              const Participant &to) const override;
    Result<EditedPlan> move(const Project &project, BusId ring, std::span<const std::size_t> devices,
                            const KindData &where) const override;
    std::optional<KindData> stepped(const Project &project, BusId ring, std::size_t device,
                                    PlanStep step) const override;
    // Onto a bus terminal: to the end of the bus where it belongs. Between the last device of a local bus and
    // the first of a branch, a device also goes where it belongs.
    std::optional<KindData> dropped(const Project &project, BusId ring, std::size_t device,
                                    std::optional<std::size_t> parent, int row) const override;
    Comparison compare(const Project &project, BusId ring, const ConnectedBus &connected) const override;
    QString comparisonText(const ComparisonLine &line, const Project &project, BusId ring,
                           const ConnectedBus &connected, const Catalog &catalog) const override;
    std::map<NodeId, Refusal> uncertain(const Project &project, BusId ring, const ConnectedBus &connected,
                                        const Catalog &catalog) const override;
    EditedPlan takenOver(const Project &project, BusId ring, const ConnectedBus &connected,
                         const Comparison &comparison, std::span<const std::size_t> lines) const override;

private:
    QString placeTitle() const override { return tr("Number"); }
    std::vector<PlanColumn> ownColumns(const Project &project, BusId ring) const override;
    std::vector<Finding> complete(std::vector<PlanRow> &rows, const Project &project, BusId ring,
                                  const Catalog &catalog) const override;
};

} // namespace codewheel
