// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_outline.h"

namespace codewheel {

class CanopenSession;

// A CAN bus with CANopen, and its encoders in the order of their numbers.
class CanopenOutline final : public BusOutline
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenOutline)

public:
    explicit CanopenOutline(const CanopenSession &bus) // must outlive it
        : m_bus(bus)
    {}

    QString title() const override;
    std::optional<QString> behindName() const override;
    QString toolTip() const override;
    QString alarmStop() const override;
    StateWord state() const override;
    std::vector<BusNode> nodes() const override;
    NodeState state(std::size_t node) const override;
    std::vector<Fault> faults() const override;
    QString toolTip(std::size_t node, const QString &called) const override;

private:
    StateWord shown(Place place) const;

    const CanopenSession &m_bus;
};

// A bus that is not connected.
class PlannedCanopenOutline final : public BusOutline
{
public:
    struct Encoder
    {
        NodeId node;
        QString name;
    };
    // Its link; empty: not given.
    PlannedCanopenOutline(QString link, std::vector<Encoder> encoders)
        : m_link(std::move(link))
        , m_encoders(std::move(encoders))
    {}

    QString title() const override;
    std::optional<QString> behindName() const override { return m_link; }
    QString toolTip() const override { return title(); }
    StateWord state() const override { return offline(); }
    std::vector<BusNode> nodes() const override;
    NodeState state(std::size_t) const override { return {planned(), {}, false}; }
    QString toolTip(std::size_t node, const QString &called) const override;

private:
    const QString m_link;
    const std::vector<Encoder> m_encoders;
};

} // namespace codewheel
