// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_growth.h"

#include <algorithm>

namespace codewheel {

void RecordingGrowth::add(Instant at, std::int64_t bytes)
{
    m_sizes.push_back({at, bytes});
    while (m_sizes.size() > 2 && m_sizes[1].at <= at - lately)
        m_sizes.pop_front();
}

std::optional<double> RecordingGrowth::bytesPerSecond() const
{
    if (m_sizes.size() < 2 || m_sizes.back().at <= m_sizes.front().at)
        return {};
    const std::chrono::duration<double> time = m_sizes.back().at - m_sizes.front().at;
    return static_cast<double>(m_sizes.back().bytes - m_sizes.front().bytes) / time.count();
}

std::optional<Instant> RecordingGrowth::timeUntilFull(std::int64_t bytesLeft) const
{
    const auto rate = bytesPerSecond();
    if (!rate || *rate <= 0)
        return {};
    const std::chrono::duration<double> left(static_cast<double>(std::max<std::int64_t>(bytesLeft, 0)) /
                                             *rate);
    return left >= longest ? longest : std::chrono::duration_cast<Instant>(left);
}

} // namespace codewheel
