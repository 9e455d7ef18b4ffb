// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"
#include "finder/place_finder.h"
#include "kinds/canopen/finder/heard_on_can.h"

#include <atomic>

namespace codewheel {

// Listens who is on the CAN bus of an interface of the system, whose rate is the system's. Nothing is sent,
// and one that would acknowledge what others send is not opened.
class CanInterfaceFinder final : public PlaceFinder
{
public:
    static constexpr Instant listening{3'000'000};

    explicit CanInterfaceFinder(std::unique_ptr<CanLink> link)
        : m_link(std::move(link))
    {}

    bool isDone() const override { return m_isDone; }
    FinderNews next() override;
    void interrupt() override
    {
        m_isStopped = true;
        m_link->interrupt();
    }

private:
    FinderNews open();
    FinderNews listen();
    FinderNews end(FinderNews news);

    std::unique_ptr<CanLink> m_link;
    HeardOnCan m_heard;
    bool m_isOpen = false;
    bool m_isDone = false;
    std::atomic<bool> m_isStopped = false;
};

} // namespace codewheel
