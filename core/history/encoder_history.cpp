// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/encoder_history.h"

#include <numeric>

namespace codewheel {

std::optional<TimeSpan> EncoderHistory::span() const
{
    std::optional<TimeSpan> all;
    for (const MemoryHistory &channel : m_channels)
        if (const auto its = channel.span())
            all = all ? TimeSpan{std::min(all->from, its->from), std::max(all->to, its->to)} : *its;
    return all;
}

void EncoderHistory::add(const ShownValues &shown)
{
    m_shown.split(shown, [&](Channel channel, const std::optional<std::int64_t> &value) {
        put(channel, shown.at, value);
    });
}

void EncoderHistory::put(Channel channel, Instant at, const std::optional<std::int64_t> &value)
{
    if (value)
        history(channel).append({at, *value});
    else
        history(channel).interrupt(at);
}

std::size_t EncoderHistory::bytes() const
{
    return std::transform_reduce(m_channels.begin(), m_channels.end(), std::size_t{0}, std::plus{},
                                 [](const MemoryHistory &channel) { return channel.bytes(); });
}

double EncoderHistory::samplesPerSecond(Instant lately) const
{
    const auto all = span();
    if (!all)
        return 0;
    const TimeSpan recent{std::max(all->from, all->to - lately), all->to};
    std::size_t samples = 0;
    for (const MemoryHistory &channel : m_channels)
        samples += channel.count(recent);
    return static_cast<double>(samples) /
           std::max(std::chrono::duration<double>(recent.to - recent.from).count(), 1.0);
}

std::optional<Instant> EncoderHistory::oldestBlockEnd() const
{
    std::optional<Instant> oldest;
    for (const MemoryHistory &channel : m_channels)
        if (const auto end = channel.oldestBlockEnd())
            oldest = oldest ? std::min(*oldest, *end) : *end;
    return oldest;
}

void EncoderHistory::forgetOldest()
{
    const auto oldest = oldestBlockEnd();
    if (!oldest)
        return;
    for (MemoryHistory &channel : m_channels)
        if (channel.oldestBlockEnd() == oldest)
            channel.forgetOldest();
}

} // namespace codewheel
