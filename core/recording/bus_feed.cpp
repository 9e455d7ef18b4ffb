// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/bus_feed.h"

#include "bus/bus_outline.h"

namespace codewheel {
namespace {

// When the newest became known of what was not so before; `otherwise`: nothing did, but something was
// forgotten.
Instant knownSince(const EncoderSession &encoder, const EncoderBus &bus, const RecordedDevice &now,
                   const ParameterValues &before, Instant otherwise)
{
    std::optional<Instant> newest;
    for (const auto &[parameter, value] : now.known)
        if (const auto known = encoder.known(parameter); known && findValue(before, parameter) != value)
            newest = std::max(newest, std::optional(bus.sinceEpoch(known->at)));
    return newest.value_or(otherwise);
}

QString nameToRecord(const EncoderBus &bus)
{
    const QString name = Place{bus.id()}.shown();
    return name.isEmpty() ? bus.outline().title() : name;
}

} // namespace

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
        const EncoderBus *bus = m_buses.open(encoder.place().bus);
        if (bus == nullptr || !m_devices.contains(encoder.place()))
            return;
        const auto reached = m_reached.find(encoder.place().bus);
        tellDevice(encoder, *bus, reached == m_reached.end() ? bus->sinceEpoch(bus->now()) : reached->second);
    });
}

void BusFeed::tellValues(const EncoderSession &encoder, const ShownSeries &shown)
{
    const Place place = encoder.place();
    const EncoderBus *bus = m_buses.open(place.bus);
    if (bus == nullptr || shown.empty())
        return;
    if (!m_reached.contains(place.bus))
        Q_EMIT came(RecordedBus{place.bus, nameToRecord(*bus)});
    tellDevice(encoder, *bus, bus->sinceEpoch(shown.front().at));
    RecordedValues entry{place, shown};
    for (ShownValues &values : entry.values)
        values.at = bus->sinceEpoch(values.at);
    m_reached[place.bus] = entry.values.back().at;
    Q_EMIT came(entry);
}

// Since it became known, which was before the window heard of it; `shown`: when it showed something last.
void BusFeed::tellDevice(const EncoderSession &encoder, const EncoderBus &bus, Instant shown)
{
    const RecordedDevice now = recordedDevice(encoder);
    const auto [place, isFirst] = m_devices.try_emplace(encoder.place(), ToldDevice{{}, shown});
    ToldDevice &told = place->second;
    if (!isFirst && told.device == now)
        return;
    told.since = std::max(told.since, knownSince(encoder, bus, now, told.device.known, shown));
    told.device = now;
    Q_EMIT came(RecordedDescription{encoder.place(), told.since, toJson(now)});
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
