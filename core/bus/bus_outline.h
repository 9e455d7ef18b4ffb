// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/fault.h"

#include <QCoreApplication>

#include <optional>
#include <vector>

namespace codewheel {

// A device on a bus, encoder or not, as lists and trees show it.
struct BusNode
{
    NodeId node;
    std::optional<std::size_t> parent; // in the list, before it; empty: directly on the bus
    bool isCoupler = false;            // others are attached to it: a bus terminal
    QString name;                      // from its description, or what it is
    QString profile;                   // "K3"; "-": not known
    QString code;                      // how the bus identifies it: "37h = 55", "12h (18)"
    QString words;                     // "2 / 2"; empty: its bus has none
    unsigned deviceCode = 0;           // 0: its bus has none
    bool makeIsOpen = false;           // nobody named it, and several in the catalog could be it

    friend bool operator==(const BusNode &, const BusNode &) = default;
};

// What changes with every frame.
struct NodeState
{
    StateWord shown;
    std::optional<std::int64_t> position;
    bool isOld = false;                     // applies to the position
    std::optional<std::int64_t> velocity{}; // revolutions per minute, shown instead of a position
    bool isCutOff = false;                  // it is behind a fault, or switched off
    bool isBehindBreak = false;             // the fault is between it and the device before it

    friend bool operator==(const NodeState &, const NodeState &) = default;
};

// A bus as displayed: its name, its state, and what is attached to it; connected, or as planned in the
// project.
class BusOutline
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::BusOutline)

public:
    virtual ~BusOutline() = default;

    // What it is, where nobody has given it a name.
    virtual QString title() const = 0;
    // What its row says behind the name of its bus, such as its port; may be empty. None: it is called by its
    // title whatever its bus is called.
    virtual std::optional<QString> behindName() const { return std::nullopt; }
    virtual QString toolTip() const = 0;
    virtual QString alarmStop() const { return tr("jobs end"); } // what ALARM STOP does there
    virtual StateWord state() const = 0;
    // In the order of the bus; valid until nodesChanged() of a connected bus, or until the project is edited.
    virtual std::vector<BusNode> nodes() const = 0;
    // By its index in nodes(); empty for one that no longer exists.
    virtual NodeState state(std::size_t node) const = 0;
    // What is wrong with the bus and its devices, in the order of the bus.
    virtual std::vector<Fault> faults() const { return {}; }
    // Everything about a node with this name ("hoist: FRABA OCD-IB K3").
    virtual QString toolTip(std::size_t node, const QString &called) const = 0;

protected:
    // For what is planned but not connected.
    static StateWord offline() { return {Role::inactive, tr("offline")}; }
    static StateWord connecting() { return {Role::attention, tr("connecting")}; }
    static StateWord planned() { return {Role::inactive, tr("planned")}; }
};

} // namespace codewheel
