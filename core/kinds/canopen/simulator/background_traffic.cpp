// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/background_traffic.h"

#include "can/can_bits.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/frames.h"
#include "kinds/canopen/protocol/nmt.h"

#include <array>

namespace codewheel::canopen {
namespace {

using Service = CobId::Service;

constexpr std::array otherNodes{110, 111, 112};
constexpr unsigned pdosOfNode = 2;
constexpr Instant beatEvery = std::chrono::seconds(1);
constexpr Instant syncEvery = std::chrono::milliseconds(100);
constexpr unsigned syncsForRequest = 10;
constexpr Instant longestBehind = std::chrono::milliseconds(20); // others had the bus: it is not made up for

std::uint32_t identifierOf(Service service, int node, int number = 0)
{
    return CobId{.service = service, .node = node, .number = number}.identifier();
}

Instant shareOf(const CanFrame &frame, int rate, int load)
{
    constexpr std::int64_t whole = 100;
    constexpr std::int64_t second = Instant::period::den;
    return Instant((canBits(frame) + canIntermission) * second * whole / (std::int64_t{rate} * load));
}

} // namespace

void BackgroundTraffic::set(const BackgroundPlan &plan)
{
    m_plan = plan;
    m_waiting.clear();
}

void BackgroundTraffic::sent(const CanFrame &frame, Instant now)
{
    m_waiting.pop_front();
    if (m_plan.load > 0)
        m_pdoAt = std::max(m_pdoAt, now - longestBehind) + shareOf(frame, m_rate, m_plan.load);
}

std::optional<Instant> BackgroundTraffic::wakesAt() const
{
    if (!m_waiting.empty() || !isOn())
        return std::nullopt;
    Instant at = Instant::max();
    if (m_plan.load > 0)
        at = std::min(m_pdoAt, m_beatAt);
    if (m_plan.hasMaster)
        at = std::min(at, m_syncAt);
    return at;
}

void BackgroundTraffic::proceed(Instant now)
{
    if (m_plan.hasMaster && m_syncAt <= now) {
        m_syncAt = now + syncEvery;
        addMastersFrames();
    }
    if (m_plan.load > 0 && m_beatAt <= now) {
        m_beatAt = now + beatEvery;
        addHeartbeats();
    }
    if (m_plan.load > 0 && m_pdoAt <= now && m_waiting.empty())
        addPdo();
}

void BackgroundTraffic::addHeartbeats()
{
    constexpr std::array beat{static_cast<std::uint8_t>(NmtState::operational)};
    for (const int node : otherNodes)
        m_waiting.push_back(frameOf(identifierOf(Service::errorControl, node), beat));
}

// Every so many SYNCs it reads the error register of one, which answers.
void BackgroundTraffic::addMastersFrames()
{
    constexpr std::array<std::uint8_t, 8> request{0x40, 0x01, 0x10, 0};
    constexpr std::array<std::uint8_t, 8> answer{0x4F, 0x01, 0x10, 0};
    m_waiting.push_back(syncFrame());
    if (++m_syncs % syncsForRequest != 0)
        return;
    m_waiting.push_back(frameOf(identifierOf(Service::sdoRequest, otherNodes.front()), request));
    m_waiting.push_back(frameOf(identifierOf(Service::sdoAnswer, otherNodes.front()), answer));
}

void BackgroundTraffic::addPdo()
{
    constexpr unsigned bitsOfOctet = 8;
    const unsigned at = m_pdos++;
    std::array<std::uint8_t, 8> octets{};
    for (std::size_t i = 0; i < octets.size(); ++i)
        octets[i] = static_cast<std::uint8_t>((at * 0x9E37U) >> (i % 2 * bitsOfOctet));
    const int node = otherNodes[at / pdosOfNode % otherNodes.size()];
    m_waiting.push_back(
        frameOf(identifierOf(Service::tpdo, node, 1 + static_cast<int>(at % pdosOfNode)), octets));
}

} // namespace codewheel::canopen
