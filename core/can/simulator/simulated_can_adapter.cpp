// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/simulator/simulated_can_adapter.h"

namespace codewheel {
namespace {

// linux/can/error.h: classes, and what the data says of the controller.
constexpr std::uint32_t controllerProblem = 0x004;
constexpr std::uint32_t protocolViolated = 0x008;
constexpr std::uint32_t nobodyAcknowledges = 0x020;
constexpr std::uint32_t wentBusOff = 0x040;
constexpr std::uint32_t busError = 0x080;
constexpr std::uint8_t overrun = 0x01;
constexpr std::uint8_t isWarning = 0x0C;
constexpr std::uint8_t isPassive = 0x30;
constexpr std::uint8_t isActive = 0x40;

CanFrame errorFrameOf(std::uint32_t classes, std::uint8_t controller = 0)
{
    return {.id = classes, .isError = true, .length = CanFrame::mostBytes, .bytes = {0, controller}};
}

CanFrame errorFrameOf(CanState state)
{
    if (state == CanState::busOff)
        return errorFrameOf(wentBusOff);
    if (state == CanState::active)
        return errorFrameOf(controllerProblem, isActive);
    return errorFrameOf(controllerProblem, state == CanState::passive ? isPassive : isWarning);
}

} // namespace

void SimulatedCanAdapter::open(CanUse use)
{
    close();
    m_use = use;
    m_open = true;
}

void SimulatedCanAdapter::close()
{
    m_open = false;
    m_state = CanState::active;
    m_queue.clear();
    m_news = {};
}

bool SimulatedCanAdapter::queue(const CanFrame &frame)
{
    if (m_state == CanState::busOff) {
        m_news.fates.push_back(CanFate::refused);
        return true;
    }
    if (m_queue.size() >= queueLength)
        return false;
    m_queue.push_back(frame);
    return true;
}

void SimulatedCanAdapter::sent(const CanFrame & /*frame*/, Instant /*now*/)
{
    m_queue.pop_front();
    m_news.fates.push_back(CanFate::done);
    look();
}

void SimulatedCanAdapter::disturbed(CanDisturbance how, Instant now)
{
    tell(errorFrameOf(busError |
                      (how == CanDisturbance::notAcknowledged ? nobodyAcknowledges : protocolViolated)),
         now);
}

void SimulatedCanAdapter::stateChanged(CanState state, Instant now)
{
    m_state = state;
    if (!isOn())
        return;
    if (state == CanState::busOff) {
        m_news.fates.insert(m_news.fates.end(), m_queue.size(), CanFate::refused);
        m_queue.clear();
    }
    tell(errorFrameOf(state), now);
}

void SimulatedCanAdapter::tell(CanFrame frame, Instant now)
{
    std::vector<CanFrame> &frames = m_news.frames;
    if (frames.size() > newsLength)
        return;
    if (frames.size() == newsLength)
        frame = errorFrameOf(controllerProblem, overrun);
    frame.time = now - m_begin;
    frames.push_back(std::move(frame));
    look();
}

void SimulatedCanAdapter::setUnplugged(bool unplugged)
{
    m_unplugged = unplugged;
    look();
}

void SimulatedCanAdapter::wake()
{
    {
        const std::scoped_lock lock(m_waking);
        m_wake = true;
    }
    m_woken.notify_all();
}

bool SimulatedCanAdapter::takeWake()
{
    const std::scoped_lock lock(m_waking);
    return std::exchange(m_wake, false);
}

void SimulatedCanAdapter::look()
{
    {
        const std::scoped_lock lock(m_waking);
        m_look = true;
    }
    m_woken.notify_all();
}

void SimulatedCanAdapter::waitFor(Instant atMost)
{
    std::unique_lock lock(m_waking);
    m_woken.wait_for(lock, atMost, [this] { return m_wake || m_look; });
    m_look = false;
}

} // namespace codewheel
