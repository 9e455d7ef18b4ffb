// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_outline.h"
#include "kinds/interbus/ring/ring_device.h"

namespace codewheel {

class RingSession;
class Catalog;

// A ring: the master, below it the remote bus, below a bus terminal its local bus and its branch.
class RingOutline final : public BusOutline
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingOutline)

public:
    explicit RingOutline(const RingSession &bus) // must outlive it
        : m_bus(bus)
    {}

    QString title() const override;
    std::optional<QString> behindName() const override;
    QString toolTip() const override;
    QString alarmStop() const override { return tr("all OUT words become 0, and jobs end"); }
    StateWord state() const override;
    std::vector<BusNode> nodes() const override;
    NodeState state(std::size_t node) const override;
    std::vector<Fault> faults() const override;
    QString toolTip(std::size_t node, const QString &called) const override;

private:
    bool isBehindGateway() const;
    StateWord shown(std::size_t node) const;
    std::optional<StateWord> faultOf(std::size_t node) const;
    bool isSwitchedOff(std::size_t node) const;
    bool isBehindBreak(std::size_t node) const;
    QString faultText(std::size_t node) const;
    QString codingText(const RingDevice &participant) const;
    QString ledsText(std::size_t node) const;

    const RingSession &m_bus;
};

// A ring that is not connected.
class PlannedRingOutline final : public BusOutline
{
public:
    PlannedRingOutline(RingStructure structure, const Catalog &catalog) // the catalog must outlive it
        : m_structure(std::move(structure))
        , m_catalog(catalog)
    {}

    QString title() const override;
    std::optional<QString> behindName() const override { return QString(); }
    QString toolTip() const override;
    StateWord state() const override { return offline(); }
    std::vector<BusNode> nodes() const override;
    NodeState state(std::size_t) const override { return {planned(), {}, false}; }
    QString toolTip(std::size_t node, const QString &called) const override;

private:
    const RingStructure m_structure;
    const Catalog &m_catalog;
};

} // namespace codewheel
