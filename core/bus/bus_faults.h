// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/fault.h"

#include <QCoreApplication>

#include <set>
#include <vector>

namespace codewheel {

class Buses;

// The faults of all open buses, worst first; those of the same rank bus by bus. A bus that was stopped by a
// fault no longer reported stays among them until it runs. Asked with each frame.
class BusFaults
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::BusFaults)

public:
    struct OnBus
    {
        BusId bus;
        Fault fault;

        bool isSameAs(const OnBus &other) const { return bus == other.bus && fault.isSameAs(other.fault); }
        friend bool operator==(const OnBus &, const OnBus &) = default;
    };

    // Valid until the next look.
    const std::vector<OnBus> &look(const Buses &buses);
    const std::vector<OnBus> &all() const { return m_all; }
    bool areOnSeveralBuses() const;

private:
    std::vector<OnBus> m_all;
    std::set<BusId> m_stoodStill;
};

} // namespace codewheel
