// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/shown_values.h"

#include <cmath>

namespace codewheel {

// What is kept of an encoder.
enum class Channel : std::uint8_t {
    position, // steps
    speed,    // thousandths of a step per second, each 10 ms at most: it is smoothed anyway (PositionSpeed)
    in,       // words; only of an encoder that has them
    out,
    cams, // that are on, bit n: cam n
};
inline constexpr std::size_t channelCount = static_cast<std::size_t>(Channel::cams) + 1;
inline constexpr double speedUnits = 1'000; // in a step per second

// What an encoder shows, channel by channel, for whoever keeps it.
class ShownChannels
{
public:
    // Calls `put` with each channel and its value; nothing: it has none from then on. A speed that need not
    // be kept is left out.
    template <class Put>
    void split(const ShownValues &shown, Put put)
    {
        using Shown = std::optional<std::int64_t>;
        put(Channel::position, Shown(shown.position));
        put(Channel::cams, Shown(shown.cams));
        put(Channel::in, shown.words ? Shown(shown.words->in) : Shown());
        put(Channel::out, shown.words ? Shown(shown.words->out) : Shown());
        if (!shown.stepsPerSecond) {
            put(Channel::speed, Shown());
            interrupt();
        } else if (m_speedAt == Instant::min() || shown.at >= m_speedAt + betweenSpeeds) {
            m_speedAt = shown.at;
            put(Channel::speed, Shown(std::llround(*shown.stepsPerSecond * speedUnits)));
        }
    }
    void interrupt() { m_speedAt = Instant::min(); }

private:
    static constexpr Instant betweenSpeeds = std::chrono::milliseconds(10);

    Instant m_speedAt = Instant::min();
};

} // namespace codewheel
