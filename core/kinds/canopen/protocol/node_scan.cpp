// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/node_scan.h"

#include "kinds/canopen/protocol/frames.h"
#include "kinds/canopen/protocol/sdo_frames.h"

#include <algorithm>
#include <utility>

namespace codewheel::canopen {
namespace {

constexpr std::array scannedObjects{SdoObject{0x1000, 0}, SdoObject{0x1018, 1}, SdoObject{0x1018, 2},
                                    SdoObject{0x1018, 3}, SdoObject{0x1018, 4}};
constexpr int mostTimes = 2;
constexpr Instant longestStuck = std::chrono::seconds(2); // assumed; while nothing is heard
constexpr Instant longestFull = std::chrono::seconds(30); // assumed
constexpr int frameBits = 135; // of a frame with eight bytes and all stuff bits, with the gap behind it

std::uint32_t sdoIdentifier(CobId::Service service, int node)
{
    return CobId{.service = service, .node = node}.identifier();
}

// Of which node it is an SDO answer; 0: of none.
int answeringNode(const CanFrame &frame)
{
    const auto cob = CobId::of(frame.id);
    return cob && cob->service == CobId::Service::sdoAnswer && isDataOf(frame, frame.id) ? cob->node : 0;
}

void keepScanned(FoundNode &found, std::size_t object, const SdoFrame &answer)
{
    if (answer.kind != SdoFrame::Kind::value)
        return;
    auto &kept = object == 0 ? found.deviceType : found.identity.at(object - 1);
    kept = numberOf(answer.data());
}

} // namespace

NodeScan::NodeScan(const NodeScanTimes &times, Instant now)
    : m_times(times)
    , m_freeAt(now)
{
    for (std::size_t at = 0; at < m_nodes.size(); ++at)
        m_nodes[at].found.node = static_cast<int>(at) + 1;
}

bool NodeScan::isSettled(const Asked &asked)
{
    return asked.object >= scannedObjects.size();
}

// Without an answer to any of it the node is not there.
void NodeScan::letPass(Asked &asked, Instant now)
{
    if (isSettled(asked) || asked.times < mostTimes || now < asked.until)
        return;
    asked.object = asked.isThere ? asked.object + 1 : scannedObjects.size();
    asked.times = 0;
}

// First what is known to be there, then what is asked again.
NodeScan::Asked *NodeScan::nextDue(Instant now)
{
    const auto rank = [](const Asked &asked) { return asked.isThere ? 0 : asked.times > 0 ? 1 : 2; };
    Asked *best = nullptr;
    for (Asked &each : m_nodes) {
        letPass(each, now);
        const bool isDue = !isSettled(each) && (each.times == 0 || now >= each.until);
        if (isDue && (best == nullptr || rank(each) < rank(*best)))
            best = &each;
    }
    return best;
}

std::optional<CanFrame> NodeScan::next(Instant now)
{
    Asked *due = nextDue(now);
    if (due == nullptr || now < m_freeAt)
        return std::nullopt;
    ++due->times;
    due->until = now + m_times.answer;
    m_lastAsked = due->found.node;
    occupy(now);
    return frameOf(sdoIdentifier(CobId::Service::sdoRequest, due->found.node),
                   sdoRead(scannedObjects.at(due->object)));
}

void NodeScan::queueFull(Instant now)
{
    if (m_lastAsked != 0)
        notSent(std::exchange(m_lastAsked, 0), now);
}

void NodeScan::fate(int node, CanFate fate, Instant now)
{
    if (fate == CanFate::refused)
        notSent(node, now);
    else
        m_stuckSince.reset();
}

void NodeScan::notSent(int node, Instant now)
{
    Asked &asked = m_nodes.at(static_cast<std::size_t>(node) - 1);
    asked.times = std::max(asked.times - 1, 0);
    asked.until = now;
    m_stuckSince = m_stuckSince.value_or(now);
    occupy(now);
}

bool NodeScan::isStuck(Instant now) const
{
    return m_stuckSince &&
           (now - std::max(*m_stuckSince, m_heardAt) >= longestStuck || now - *m_stuckSince >= longestFull);
}

void NodeScan::occupy(Instant now)
{
    constexpr std::int64_t wholeShare = 100;
    constexpr std::int64_t second = Instant::period::den;
    const std::int64_t bitsOfShare =
        std::max(std::int64_t{m_times.rate} * m_times.share / wholeShare, std::int64_t{1});
    m_freeAt = std::max(m_freeAt, now) + Instant(frameBits * second / bitsOfShare);
}

bool NodeScan::take(const CanFrame &frame, Instant now)
{
    const int node = answeringNode(frame);
    const auto answer = node == 0 ? std::nullopt : SdoFrame::answer(frame.data());
    if (!answer || answer->kind == SdoFrame::Kind::unknown)
        return node != 0;
    occupy(now);
    m_stuckSince.reset();
    Asked &asked = m_nodes.at(static_cast<std::size_t>(node) - 1);
    if (isSettled(asked) && !asked.isThere) // it was given up too early
        asked.object = 0;
    asked.isThere = true;
    const auto found = std::ranges::find(scannedObjects, answer->object);
    if (found == scannedObjects.end())
        return true;
    const auto object = static_cast<std::size_t>(found - scannedObjects.begin());
    keepScanned(asked.found, object, *answer);
    if (object != asked.object)
        return true;
    ++asked.object;
    asked.times = 0;
    return true;
}

std::optional<Instant> NodeScan::wakesAt() const
{
    std::optional<Instant> wakes;
    for (const Asked &each : m_nodes) {
        if (isSettled(each))
            continue;
        const Instant due = each.times == 0          ? m_freeAt
                            : each.times < mostTimes ? std::max(each.until, m_freeAt)
                                                     : each.until;
        wakes = std::min(wakes.value_or(due), due);
    }
    return wakes;
}

int NodeScan::progress() const
{
    return static_cast<int>(std::ranges::count_if(m_nodes, &NodeScan::isSettled));
}

std::vector<FoundNode> NodeScan::found() const
{
    std::vector<FoundNode> found;
    for (const Asked &each : m_nodes)
        if (each.isThere)
            found.push_back(each.found);
    return found;
}

} // namespace codewheel::canopen
