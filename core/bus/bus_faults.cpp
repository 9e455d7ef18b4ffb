// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_faults.h"

#include "bus/bus_outline.h"
#include "bus/buses.h"

#include <algorithm>

namespace codewheel {

int rankOf(const Fault &fault)
{
    if (fault.extent == Fault::Extent::standstill)
        return 0;
    return fault.shown.role == Role::fault ? 1 : 2;
}

const std::vector<BusFaults::OnBus> &BusFaults::look(const Buses &buses)
{
    m_all.clear();
    const auto before = std::exchange(m_stoodStill, {});
    for (const EncoderBus *bus : buses.open()) {
        for (Fault &fault : bus->outline().faults()) {
            if (fault.extent == Fault::Extent::standstill)
                m_stoodStill.insert(bus->id());
            m_all.push_back({bus->id(), std::move(fault)});
        }
        if (bus->isRunning() || m_stoodStill.contains(bus->id()) || !before.contains(bus->id()))
            continue;
        m_stoodStill.insert(bus->id());
        const StateWord state = bus->outline().state();
        m_all.push_back(
            {bus->id(),
             {.extent = Fault::Extent::standstill,
              .shown = {Role::attention, state.word},
              .text = tr("The fault is not told any more, but the bus is stopped. Start it again."),
              .actions = {FaultAction::start}}});
    }
    std::ranges::stable_sort(m_all, {}, [](const OnBus &one) { return rankOf(one.fault); });
    return m_all;
}

bool BusFaults::areOnSeveralBuses() const
{
    return std::ranges::any_of(m_all, [this](const OnBus &one) { return one.bus != m_all.front().bus; });
}

} // namespace codewheel
