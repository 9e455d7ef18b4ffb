// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"
#include "ring/ring_edit.h"
#include "widgets/project/project_document.h"

namespace codewheel {

class Catalog;

// What can be done to the planned ring: each a step of undo, or refused in words. Used by the structure
// editor, its model when something is dropped, and the comparison.
class PlanEdits
{
public:
    using Id = ProjectDocument::DeviceId;
    using Ids = std::vector<Id>;

    // Both must outlive it.
    PlanEdits(ProjectDocument &document, const Catalog &catalog)
        : m_document(document)
        , m_catalog(catalog)
    {}

    void setRing(BusId ring) { m_ring = ring; } // the first one at first
    Result<Id> insert(const Participant &device, const RingPlace &place);
    Result<void> remove(const Ids &devices); // with all that hangs below
    Result<void> move(const Ids &devices, const RingPlace &place);
    // Another kind of device in this place; station, group, note and addresses stay.
    Result<void> change(Id device, const Participant &to);

    // By keys: before or behind its neighbour; below the bus terminal before it; out again, behind its
    // terminal; from the local bus to the branch and back. Nothing happens where there is no such place.
    Result<void> moveBy(Id device, int rows);
    Result<void> moveIn(Id device);
    Result<void> moveOut(Id device);
    Result<void> changeBus(Id device);

    std::optional<RingPlace> placeOf(Id device) const;

private:
    RingStructure structure() const;
    const Participant &participant(Id device) const;
    QString nameOf(Id device) const;
    Result<void> apply(const Result<EditedRing> &edited, const QString &what);

    ProjectDocument &m_document;
    const Catalog &m_catalog;
    BusId m_ring = firstRing;
};

} // namespace codewheel
