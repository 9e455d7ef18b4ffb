// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_units.h"
#include "kinds/interbus/ring/ring_session.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace codewheel::test {

// A ring that is offered, whose cycles pass without a pause in a thread of their own.
class OfferedRing
{
public:
    OfferedRing(std::unique_ptr<ProcessDataLink> link, const Catalog &catalog)
        : m_bus(std::move(link), catalog, QDateTime::currentDateTime())
    {
        m_bus.offerTo(m_guests);
        if (!m_bus.open(EncoderBus::Start::operating))
            qFatal("the ring does not open");
        m_bus.advance(1);
        m_bus.startThread(std::chrono::microseconds(200));
    }

    RingSession &bus() { return m_bus; }
    const std::shared_ptr<RingGuests> &guests() const { return m_guests; }
    // Takes what comes from the bus until it is so.
    template <typename Condition>
    bool waitFor(Condition condition)
    {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        while (std::chrono::steady_clock::now() < end) {
            m_bus.pump();
            if (condition())
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }

private:
    std::shared_ptr<RingGuests> m_guests = std::make_shared<RingGuests>();
    RingSession m_bus;
};

} // namespace codewheel::test
