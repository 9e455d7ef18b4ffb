// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_estimate.h"

#include "history/histories.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant lastSeconds = 10s;
constexpr double bytesOfSample = 2; // docs/recording-files.md, "What it costs"
constexpr double bytesOfRow = 60;   // of traffic, roughly

double inSeconds(Instant duration)
{
    return std::chrono::duration<double>(duration).count();
}

} // namespace

RecordingEstimate::RecordingEstimate(Buses &buses, const Histories &histories, QObject *parent)
    : QObject(parent)
    , m_buses(buses)
    , m_histories(histories)
{
    for (EncoderBus *bus : buses.connected()) {
        m_passed[bus->id()].since = bus->now();
        connect(bus, &EncoderBus::trafficPassed, this, [this, id = bus->id()](const TrafficRow &row) {
            ++m_passed[id].rows[row.place.value_or(Place{id, {}})];
        });
    }
}

double RecordingEstimate::trafficBytesPerSecond(const std::set<Place> &places) const
{
    double bytes = 0;
    for (const auto &[id, passed] : m_passed) {
        const EncoderBus *bus = m_buses.open(id);
        if (bus == nullptr || bus->now() <= passed.since)
            continue;
        for (const auto &[place, rows] : passed.rows)
            if (places.empty() || place.isEmpty() || places.contains(place))
                bytes += static_cast<double>(rows) * bytesOfRow / inSeconds(bus->now() - passed.since);
    }
    return bytes;
}

std::optional<double> RecordingEstimate::bytesPerSecond(const std::set<Place> &places, bool withTraffic) const
{
    std::optional<double> samples;
    for (const Place place : m_histories.places())
        if (const EncoderHistory *history = m_histories.of(place);
            history != nullptr && history->span() && (places.empty() || places.contains(place)))
            samples = samples.value_or(0) + history->samplesPerSecond(lastSeconds);
    if (!samples)
        return {};
    return *samples * bytesOfSample + (withTraffic ? trafficBytesPerSecond(places) : 0);
}

} // namespace codewheel
