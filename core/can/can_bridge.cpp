// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_bridge.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant untilThereIsRoom = 1ms;

} // namespace

Result<void> CanBridge::carry(Instant atMost)
{
    const auto sent = m_near.receive(m_near.now()).and_then([this](const CanNews &news) {
        take(news, m_toFar);
        return sendWhatFits(m_far, m_toFar);
    });
    if (!sent)
        return sent;
    const bool isFull = !m_toFar.empty() || !m_toNear.empty();
    return m_far.receive(m_far.now() + (isFull ? std::min(atMost, untilThereIsRoom) : atMost))
        .and_then([this](const CanNews &news) {
            take(news, m_toNear);
            return sendWhatFits(m_near, m_toNear);
        });
}

void CanBridge::take(const CanNews &news, Frames &frames)
{
    for (const CanFrame &frame : news.frames) {
        if (frame.isError)
            continue;
        if (frames.size() < mostWaiting)
            frames.push_back(frame);
        else
            ++m_lost;
    }
}

Result<void> CanBridge::sendWhatFits(CanLink &link, Frames &frames)
{
    while (!frames.empty()) {
        const auto isTaken = link.send(frames.front());
        if (!isTaken)
            return tl::unexpected(isTaken.error());
        if (!*isTaken)
            break;
        frames.pop_front();
    }
    return {};
}

} // namespace codewheel
