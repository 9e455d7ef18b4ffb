// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/simulator/simulated_can_link.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct SimulatedCan
{
    Q_DECLARE_TR_FUNCTIONS(SimulatedCan)
};

} // namespace

SimulatedCanLink::SimulatedCanLink(std::shared_ptr<SimulatedCanBus> bus, int rate, Clock clock)
    : m_bus(std::move(bus))
    , m_clock(std::move(clock))
    , m_begin(m_clock ? m_clock() : Instant())
    , m_busBegin(m_bus->now())
    , m_adapter(std::make_shared<SimulatedCanAdapter>(rate, m_busBegin))
{
    m_bus->add(m_adapter);
}

SimulatedCanLink::~SimulatedCanLink()
{
    m_bus->remove(*m_adapter);
}

Result<void> SimulatedCanLink::open(CanUse use)
{
    close();
    if (m_adapter->isUnplugged())
        return refuse(RefusalKind::link, RefusalId::linkFailed,
                      {SimulatedCan::tr("The simulated adapter is unplugged.")});
    m_bus->advance(m_busBegin + now());
    m_bus->restart(*m_adapter);
    m_bus->locked([&] { m_adapter->open(use); });
    m_open = true;
    return {};
}

void SimulatedCanLink::close()
{
    m_bus->locked([&] { m_adapter->close(); });
    m_open = false;
}

QString SimulatedCanLink::name() const
{
    return SimulatedCan::tr("simulated bus");
}

Result<CanNews> SimulatedCanLink::receive(Instant until)
{
    if (const auto checked = usable(); !checked)
        return tl::unexpected(checked.error());
    passTime(until, true);
    if (const auto checked = usable(); !checked)
        return tl::unexpected(checked.error());
    return m_bus->locked([&] { return m_adapter->takeNews(); });
}

Result<bool> SimulatedCanLink::send(const CanFrame &frame)
{
    if (const auto checked = usable(); !checked)
        return tl::unexpected(checked.error());
    if (m_adapter->listensOnly())
        return refuse(RefusalKind::link, RefusalId::linkFailed,
                      {SimulatedCan::tr("The simulated bus was opened to watch: nothing is sent.")});
    m_bus->advance(m_busBegin + now());
    return m_bus->locked([&] { return m_adapter->queue(frame); });
}

CanStatus SimulatedCanLink::status() const
{
    if (!m_open)
        return {};
    const CanErrorCounters errors = m_bus->errorsOf(*m_adapter);
    return {.state = errors.state(),
            .transmitErrors = errors.transmit(),
            .receiveErrors = errors.receive(),
            .rate = m_adapter->rate(),
            .listensOnly = m_adapter->listensOnly()};
}

Result<void> SimulatedCanLink::usable()
{
    if (!m_open)
        return refuse(RefusalKind::link, RefusalId::linkFailed,
                      {SimulatedCan::tr("The simulated bus is not open.")});
    if (m_adapter->isUnplugged()) {
        close();
        return refuse(RefusalKind::link, RefusalId::linkFailed,
                      {SimulatedCan::tr("The simulated adapter was unplugged.")});
    }
    return {};
}

void SimulatedCanLink::passTime(Instant until, bool upToNews)
{
    const auto isEnough = [&] {
        return m_adapter->takeWake() || (upToNews && (m_adapter->hasNews() || m_adapter->isUnplugged()));
    };
    if (!m_clock) {
        m_bus->advance(m_busBegin + until, isEnough);
        return;
    }
    for (;;) {
        const Instant time = now();
        m_bus->advance(m_busBegin + time);
        if (time >= until || m_bus->locked(isEnough))
            return;
        const Instant next = m_bus->nextEvent().value_or(m_busBegin + until) - m_busBegin;
        m_adapter->waitFor(std::min(until, next) - time);
    }
}

} // namespace codewheel
