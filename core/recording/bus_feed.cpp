// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/bus_feed.h"

#include "bus/bus_outline.h"
#include "recording/recorded_device.h"

namespace codewheel {

BusFeed::BusFeed(Buses &buses, WallClockNow now, QObject *parent)
    : QObject(parent)
    , m_buses(buses)
    , m_now(std::move(now))
{
    connect(&buses, &Buses::changed, this, &BusFeed::watchAll);
    connect(&buses, &Buses::updated, this, &BusFeed::tellClock);
    watchAll();
}

void BusFeed::watchAll()
{
    tellClosed();
    for (EncoderBus *bus : m_buses.connected()) {
        watch(*bus);
        for (const Place place : bus->places())
            if (EncoderSession *encoder = bus->encoder(place))
                watch(*encoder);
    }
}

// Of an encoder whose bus is closed nothing is known from then on.
void BusFeed::tellClosed()
{
    std::erase_if(m_reached, [this](const auto &reached) {
        const auto &[bus, at] = reached;
        if (m_buses.open(bus) != nullptr)
            return false;
        Q_EMIT came(RecordedInterruption{Place{bus, {}}, at});
        return true;
    });
}

void BusFeed::watch(EncoderBus &bus)
{
    if (!m_watched.insert(&bus).second)
        return;
    connect(&bus, &QObject::destroyed, this, [this](QObject *gone) { m_watched.erase(gone); });
    connect(&bus, &EncoderBus::messaged, this, [this, &bus](const Message &message) {
        Q_EMIT came(RecordedMessage{bus.sinceEpoch(message.at), message});
    });
    connect(&bus, &EncoderBus::trafficPassed, this, [this, &bus](const TrafficRow &row) {
        Q_EMIT came(RecordedTraffic{bus.sinceEpoch(row.at), bus.id(), row});
    });
    connect(&bus, &EncoderBus::valuesDropped, this, [this, &bus](std::uint64_t count) {
        Q_EMIT came(RecordedLoss{bus.sinceEpoch(bus.now()), bus.id(), count});
    });
}

void BusFeed::watch(EncoderSession &encoder)
{
    if (!m_watched.insert(&encoder).second)
        return;
    connect(&encoder, &QObject::destroyed, this, [this](QObject *gone) { m_watched.erase(gone); });
    connect(&encoder, &EncoderSession::shown, this,
            [this, &encoder](const ShownSeries &shown) { tellValues(encoder, shown); });
    connect(&encoder, &EncoderSession::knownChanged, this, [this, &encoder] {
        if (const EncoderBus *bus = m_buses.open(encoder.place().bus);
            bus && m_devices.contains(encoder.place()))
            tellDevice(encoder, *bus);
    });
}

void BusFeed::tellValues(const EncoderSession &encoder, const ShownSeries &shown)
{
    const Place place = encoder.place();
    const EncoderBus *bus = m_buses.open(place.bus);
    if (bus == nullptr || shown.empty())
        return;
    if (!m_reached.contains(place.bus))
        Q_EMIT came(RecordedBus{place.bus, bus->outline().title()});
    tellDevice(encoder, *bus);
    RecordedValues entry{place, shown};
    for (ShownValues &values : entry.values)
        values.at = bus->sinceEpoch(values.at);
    m_reached[place.bus] = entry.values.back().at;
    Q_EMIT came(entry);
}

void BusFeed::tellDevice(const EncoderSession &encoder, const EncoderBus &bus)
{
    const QByteArray json = toJson(recordedDevice(encoder));
    if (QByteArray &told = m_devices[encoder.place()]; std::exchange(told, json) != json)
        Q_EMIT came(RecordedDescription{encoder.place(), bus.sinceEpoch(bus.now()), json});
}

// By the clock of one bus, since they may be apart.
void BusFeed::tellClock(BusId bus)
{
    const std::vector<EncoderBus *> open = m_buses.connected();
    if (open.empty() || open.front()->id() != bus)
        return;
    Q_EMIT came(RecordedClock{open.front()->sinceEpoch(open.front()->now()),
                              std::chrono::milliseconds(m_now().toMSecsSinceEpoch())});
}

} // namespace codewheel
