// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/memory_history.h"
#include "history/shown_channels.h"

#include <array>

namespace codewheel {

// What an encoder has shown. Times are those of the day: since 1970, UTC, by the clock of its bus, so that
// those of several buses stand on one axis.
class EncoderHistory
{
public:
    const MemoryHistory &of(Channel channel) const { return m_channels[static_cast<std::size_t>(channel)]; }
    // From the oldest to the newest of all channels.
    std::optional<TimeSpan> span() const;

    void add(const ShownValues &shown); // its time is that of the day

    std::size_t bytes() const;
    double samplesPerSecond(Instant lately) const; // kept, over the last `lately`
    // Where the oldest block of all ends; nothing: there is only what is newest.
    std::optional<Instant> oldestBlockEnd() const;
    void forgetOldest();

private:
    MemoryHistory &history(Channel channel) { return m_channels[static_cast<std::size_t>(channel)]; }
    void put(Channel channel, Instant at, const std::optional<std::int64_t> &value);

    std::array<MemoryHistory, channelCount> m_channels;
    ShownChannels m_shown;
};

} // namespace codewheel
