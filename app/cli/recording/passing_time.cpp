// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/recording/passing_time.h"

#include "bus/buses.h"
#include "cli/bus/bus_access.h"

#include <algorithm>
#include <poll.h>

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds timeSlice{20};

bool isOpenBus(const BusAccess *bus)
{
    return bus->bus().isOpen();
}

// They may have waited for each other's encoders. One alone keeps its own, as that of a log.
void setSimulatedTime(const Call &call)
{
    if (call.buses.open().size() < 2)
        return;
    QDateTime latest = QDateTime::currentDateTimeUtc();
    for (const EncoderBus *bus : call.buses.open())
        latest = std::max(latest, bus->dateTime(bus->now()));
    for (EncoderBus *bus : call.buses.open())
        if (bus->isSimulated())
            bus->setTime(latest);
}

} // namespace

PassingTime::PassingTime(const Call &call, Pace pace)
    : m_call(call)
    , m_isVirtual(pace == Pace::asFastAsPossible &&
                  std::ranges::all_of(call.buses.open(), &EncoderBus::isSimulated))
{
    setSimulatedTime(call);
    for (BusAccess *bus : call.links)
        if (isOpenBus(bus))
            (bus->startThread() ? m_byThemselves : m_byHand).push_back(bus);
}

void PassingTime::goOn(const StopSignals &stop)
{
    for (BusAccess *bus : m_byHand)
        bus->advance(timeSlice);
    for (const BusAccess *bus : m_byThemselves)
        bus->bus().pump();
    m_passed += timeSlice;
    if (!m_isVirtual)
        wait(stop);
}

// What a slow computer missed is not caught up.
void PassingTime::wait(const StopSignals &stop)
{
    m_next = std::max(m_next + timeSlice, Clock::now());
    pollfd signal{stop.descriptor(), POLLIN, 0};
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(m_next - Clock::now());
    if (left.count() > 0)
        (void)::poll(&signal, 1, static_cast<int>(left.count()));
}

Instant PassingTime::passed() const
{
    return m_isVirtual ? m_passed : std::chrono::duration_cast<Instant>(Clock::now() - m_begin);
}

QDateTime PassingTime::now() const
{
    const std::vector<EncoderBus *> open = m_call.buses.open();
    if (!m_isVirtual || open.empty())
        return QDateTime::currentDateTimeUtc();
    return open.front()->dateTime(open.front()->now());
}

} // namespace codewheel
