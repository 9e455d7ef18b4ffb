// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/fault.h"

#include <QCoreApplication>

#include <optional>
#include <vector>

namespace codewheel {

// A device of a bus, encoder or not, as lists and trees show it.
struct BusNode
{
    NodeId node;
    std::optional<std::size_t> parent; // in the list, before it; nothing: it hangs on the bus itself
    bool isCoupler = false;            // others hang on it: a bus terminal
    QString name;                      // of its description, or what it is
    QString profile;                   // "K3"; "-": not known
    QString code;                      // by which the bus knows it: "37h = 55", "12h (18)"
    QString words;                     // "2 / 2"; empty: its bus has none
    unsigned deviceCode = 0;           // 0: its bus tells none
    bool makeIsOpen = false;           // nobody named it, and the catalog has several that it could be

    friend bool operator==(const BusNode &, const BusNode &) = default;
};

// What changes with every frame.
struct NodeState
{
    StateWord shown;
    std::optional<std::int64_t> position;
    bool isOld = false;                     // the position
    std::optional<std::int64_t> velocity{}; // revolutions per minute, shown in place of a position
    bool isCutOff = false;                  // a fault lies before it, or it is switched off
    bool isBehindBreak = false;             // the fault is between it and the device before it

    friend bool operator==(const NodeState &, const NodeState &) = default;
};

// A bus as it is looked at: what it is called, how it stands, and what hangs on it; connected, or as the
// project plans it.
class BusOutline
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::BusOutline)

public:
    virtual ~BusOutline() = default;

    virtual QString title() const = 0;
    virtual QString toolTip() const = 0;
    virtual QString alarmStop() const { return tr("jobs end"); } // what ALARM STOP does there
    virtual StateWord state() const = 0;
    // In the order of the bus; it stays until nodesChanged() of a connected bus, or until the project is
    // edited.
    virtual std::vector<BusNode> nodes() const = 0;
    // By its place in nodes(); of one that is not there any more nothing is told.
    virtual NodeState state(std::size_t node) const = 0;
    // What is wrong with the bus and what hangs on it, in the order of the bus.
    virtual std::vector<Fault> faults() const { return {}; }
    // All that is told of a node that is called so ("hoist: FRABA OCD-IB K3").
    virtual QString toolTip(std::size_t node, const QString &called) const = 0;

protected:
    // Of what is planned, and not connected.
    static StateWord offline() { return {Role::inactive, tr("offline")}; }
    static StateWord connecting() { return {Role::attention, tr("connecting")}; }
    static StateWord planned() { return {Role::inactive, tr("planned")}; }
};

} // namespace codewheel
