// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/channel_blocks.h"
#include "recording/recording_clock.h"

namespace codewheel {

// Turns what comes into a recording into the rows of its tables. Does no I/O; used by RecordingWriter in its
// thread.
class RecordingComposer
{
public:
    RecordingComposer() = default;
    RecordingComposer(const RecordingComposer &) = delete; // its channels share a counter
    RecordingComposer &operator=(const RecordingComposer &) = delete;

    void add(const RecordingEntry &entry);
    // All that has yet to be written, up to now; it stays there until forgotten.
    RecordingChanges &gathered();
    void forgetWritten() { m_changes = {}; }

private:
    struct Device
    {
        DeviceRow row;
        ShownChannels shown{};
        std::array<std::optional<ChannelBlocks>, channelCount> channels{};
    };

    void take(const RecordedBus &entry);
    void take(const RecordedDescription &entry);
    void take(const RecordedValues &entry);
    void take(const RecordedPast &entry);
    void take(const RecordedInterruption &entry);
    void take(const RecordedMessage &entry);
    void take(const RecordedTraffic &entry);
    void take(const RecordedNote &entry);
    void take(const RecordedLoss &entry);
    void take(const RecordedClock &entry);

    Device &device(Place place);
    ChannelBlocks &channel(Device &device, Channel channel);
    void add(Device &device, const ShownValues &shown);
    void interrupt(Device &device, Instant at);
    void reach(Instant at) { m_changes.until = m_until = std::max(m_until, at); }
    void reach(Device &device, Instant at);

    std::map<Place, Device> m_devices;
    ClockWatch m_clock;
    Instant m_until{};
    RecordingChanges m_changes;
    qint64 m_nextChannel = 1;
    qint64 m_nextBlock = 1;
    qint64 m_nextRow = 1; // of messages, traffic and losses
};

} // namespace codewheel
