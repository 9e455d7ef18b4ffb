// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "recording/recorded_device.h"
#include "recording/recording_entry.h"

#include <functional>
#include <set>

namespace codewheel {

// Everything that happens on all buses, as it comes into a recording. Used by BusRecorder.
class BusFeed : public QObject
{
    Q_OBJECT

public:
    // The date and time by the clock of the computer.
    using WallClockNow = std::function<QDateTime()>;

    BusFeed(Buses &buses, WallClockNow now, QObject *parent = nullptr);

Q_SIGNALS:
    // In the order it came; what has to be known of an encoder comes before its values.
    void came(const codewheel::RecordingEntry &entry);

private:
    struct ToldDevice // last
    {
        RecordedDevice device;
        Instant since{};
    };

    void watchAll();
    void watch(EncoderBus &bus);
    void watch(EncoderSession &encoder);
    void tellValues(const EncoderSession &encoder, const ShownSeries &shown);
    void tellDevice(const EncoderSession &encoder, const EncoderBus &bus, Instant shown);
    void tellClock(BusId bus);
    void tellClosed();

    Buses &m_buses;
    const WallClockNow m_now;
    std::set<const QObject *> m_watched;
    std::map<BusId, Instant> m_reached; // of each that was open: the newest time
    std::map<Place, ToldDevice> m_devices;
};

} // namespace codewheel
