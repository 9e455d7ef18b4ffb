// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/buses.h"

#include <algorithm>
#include <iterator>

namespace codewheel {

void Buses::add(EncoderBus &bus)
{
    m_buses.insert(std::ranges::upper_bound(m_buses, bus.id(), {}, &EncoderBus::id), &bus);
    connect(&bus, &EncoderBus::stateChanged, this, &Buses::changed);
    connect(&bus, &EncoderBus::nodesChanged, this, &Buses::changed);
    connect(&bus, &EncoderBus::updated, this, [this, id = bus.id()] { Q_EMIT updated(id); });
    connect(&bus, &QObject::destroyed, this, [this, gone = &bus] { std::erase(m_buses, gone); });
    Q_EMIT changed();
}

void Buses::remove(const EncoderBus *bus)
{
    if (!has(bus))
        return;
    std::erase(m_buses, bus);
    bus->disconnect(this);
    Q_EMIT changed();
}

std::vector<EncoderBus *> Buses::open() const
{
    std::vector<EncoderBus *> open;
    std::ranges::copy_if(m_buses, std::back_inserter(open), &EncoderBus::isOpen);
    return open;
}

std::vector<EncoderBus *> Buses::connected() const
{
    std::vector<EncoderBus *> connected = open();
    std::erase_if(connected, &EncoderBus::isReplay);
    return connected;
}

EncoderBus *Buses::open(BusId bus) const
{
    const auto found = std::ranges::find_if(
        m_buses, [bus](const EncoderBus *its) { return its->id() == bus && its->isOpen(); });
    return found == m_buses.end() ? nullptr : *found;
}

bool Buses::isOpening(BusId bus) const
{
    return std::ranges::any_of(m_buses, [bus](const EncoderBus *its) {
        return its->id() == bus && its->state() == BusState::opening;
    });
}

std::vector<Place> Buses::places() const
{
    std::vector<Place> all;
    for (const EncoderBus *bus : open())
        std::ranges::copy(bus->places(), std::back_inserter(all));
    return all;
}

EncoderBus *Buses::busOf(Place place) const
{
    for (EncoderBus *bus : open()) {
        const std::vector<Place> its = bus->places();
        if (std::ranges::find(its, place) != its.end())
            return bus;
    }
    return nullptr;
}

// Each bus answers only for its own places.
EncoderSession *Buses::encoder(Place place) const
{
    for (const EncoderBus *bus : open())
        if (EncoderSession *its = bus->encoder(place))
            return its;
    return nullptr;
}

WordChannel *Buses::channel(Place place) const
{
    for (const EncoderBus *bus : open())
        if (WordChannel *its = bus->channel(place))
            return its;
    return nullptr;
}

Refusal Buses::whyNotThere(Place place) const
{
    const EncoderBus *bus = open(place.bus);
    return bus ? bus->whyNotThere(place) : notConnected(place);
}

QDateTime Buses::now(Place place) const
{
    const std::vector<EncoderBus *> buses = open();
    const EncoderBus *bus = open(place.bus);
    if (bus == nullptr && !buses.empty())
        bus = buses.front();
    return bus ? bus->dateTime(bus->now()) : QDateTime();
}

bool Buses::hasJob() const
{
    return std::ranges::any_of(places(), [this](Place place) {
        const EncoderSession *of = encoder(place);
        return of != nullptr && of->runningJob();
    });
}

// What one of them reports meanwhile may remove another.
template <typename Call>
void Buses::callEach(Call call)
{
    const std::vector<EncoderBus *> buses = m_buses;
    for (EncoderBus *bus : buses)
        if (has(bus) && bus->state() != BusState::closed)
            call(*bus);
}

void Buses::pump()
{
    callEach([](EncoderBus &bus) { bus.pump(); });
}

void Buses::alarmStop()
{
    callEach([](EncoderBus &bus) { bus.alarmStop(); });
}

} // namespace codewheel
