// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_outline.h"

namespace codewheel {

class ReplayBus;

// A bus of a recording, and its devices, at the moment shown.
class ReplayOutline final : public BusOutline
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ReplayOutline)

public:
    explicit ReplayOutline(const ReplayBus &bus) // must outlive it
        : m_bus(bus)
    {}

    QString title() const override;
    QString toolTip() const override;
    QString alarmStop() const override { return tr("nothing: it is a recording"); }
    StateWord state() const override;
    std::vector<BusNode> nodes() const override;
    NodeState state(std::size_t node) const override;
    QString toolTip(std::size_t node, const QString &called) const override;

private:
    StateWord shown(Place place) const;

    const ReplayBus &m_bus;
};

} // namespace codewheel
