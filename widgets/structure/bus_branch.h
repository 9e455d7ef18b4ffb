// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_outline.h"
#include "bus/encoder_bus.h"

#include <memory>
#include <vector>

namespace codewheel {

class ProjectDocument;

// A bus in the tree of the bus structure: its own row and those of its devices. Used by StructureModel, which
// notifies the views.
struct BusBranch
{
    struct Row
    {
        quintptr id = 0; // by which views know it, while it exists
        BusNode node;
        QString station;      // from the project; empty: none
        bool isOther = false; // than the project plans there, by its device code
        NodeState state;
        std::vector<std::size_t> children; // in `rows`
        std::size_t place = 0;             // among its siblings
    };

    BusId bus;
    quintptr id = 0;
    EncoderBus *connected = nullptr;             // null: only planned
    std::shared_ptr<const BusOutline> planned{}; // null: not planned, or connected
    QString title{};
    StateWord state{};
    QString mode{};                 // Watch or Operate; empty: not connected
    std::vector<Row> rows{};        // in the order of the bus
    std::vector<std::size_t> top{}; // those on the bus itself

    const BusOutline &outline() const { return connected ? connected->outline() : *planned; }
    QString modeNow() const;
    bool isFlat() const { return top.size() == rows.size(); }
    std::optional<std::size_t> find(NodeId node) const;
    const std::vector<std::size_t> &siblings(const Row &row) const;
    // To be called after rows were added or removed: sets children and places.
    void arrange();
    Row make(quintptr rowId, std::size_t node, const BusNode &what, const ProjectDocument *project) const;
    QString stationOf(const BusNode &node, const ProjectDocument *project) const;
    bool isOther(const BusNode &node, const ProjectDocument *project) const;
    NodeState stateOf(std::size_t row) const;
};

// "hoist: Kübler 5882", or only the latter: the station comes first, as people at the plant use it.
QString calledText(const QString &station, const QString &name);

} // namespace codewheel
