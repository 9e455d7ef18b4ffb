// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/plan_rules.h"
#include "widgets/project/project_document.h"

namespace codewheel {

class BusKind;

// The edits of the devices of a planned bus, by the rules of its kind: each an undo step, or refused with a
// reason. Used by the structure editor, by its model for input and drops, and by the comparison.
class PlanEdits
{
public:
    using Id = ProjectDocument::DeviceId;
    using Ids = std::vector<Id>;

    // Both must outlive it. Starts with the first ring.
    PlanEdits(ProjectDocument &document, const Catalog &catalog)
        : m_document(document)
        , m_catalog(catalog)
    {}

    ProjectDocument &document() const { return m_document; }
    const Project &project() const { return m_document.project(); }
    const Catalog &catalog() const { return m_catalog; }
    BusId bus() const { return m_bus; }
    // `kind`: for a bus that will only be planned with its first device.
    void setBus(BusId bus, const QString &kind = {});
    QString kindKey() const; // empty: not known
    const PlanRules &rules() const;
    std::vector<PlanRow> rows() const;
    QString nameOf(const Participant &device) const { return rules().nameOf(device, m_catalog); }
    QString codeOf(const Participant &device) const { return rules().codeOf(device); }

    Result<Id> insert(const Participant &device, const KindData &where);
    Result<void> remove(const Ids &devices); // with everything below them
    Result<void> move(const Ids &devices, const KindData &where);
    Result<void> move(Id device, PlanStep step); // does nothing if there is no such place
    Result<void> drop(const Ids &devices, std::optional<Id> parent, int row);
    // Another kind of device in this place; station, group, note and addresses are kept.
    Result<void> change(Id device, const Participant &to);
    // Takes over these lines of a comparison with what is connected.
    void takeOver(const ConnectedBus &connected, const Comparison &comparison,
                  std::span<const std::size_t> lines, const QString &what);
    Result<void> type(Id device, const PlanColumn &column, const QString &text);

private:
    const BusKind *kind() const; // null: this program does not know it
    QString placeOf(Id device) const { return m_document.device(device)->place().toString(); }
    std::vector<std::size_t> indicesOf(const Ids &devices) const;
    Result<void> apply(Result<EditedPlan> edited, const QString &what);

    ProjectDocument &m_document;
    const Catalog &m_catalog;
    BusId m_bus = firstBus;
    QString m_kind;
};

} // namespace codewheel
