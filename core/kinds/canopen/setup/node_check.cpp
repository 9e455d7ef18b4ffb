// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/setup/node_check.h"

#include <utility>

namespace codewheel::canopen {
namespace {

constexpr Instant longestBoot = std::chrono::seconds(5);
constexpr Instant untilAskedAgain = std::chrono::milliseconds(200);

} // namespace

BootUps BootUps::of(const CanopenSnapshot &bus, int node)
{
    const CanopenSnapshot::Node *heard = bus.heard(node);
    return heard != nullptr ? BootUps{heard->bootUps, heard->unaskedBootUps} : BootUps();
}

NodeCheck::NodeCheck(const Wanted &wanted)
    : m_wanted(wanted)
    , m_reading(wanted.node)
{}

std::optional<NodeTask::Request> NodeCheck::next(const CanopenSnapshot &bus)
{
    m_now = bus.at;
    if (!m_until) {
        m_until = m_now + longestBoot;
        m_dueAt = m_now + untilAskedAgain; // it may be about to boot
    }
    const BootUps bootUps = BootUps::of(bus, m_wanted.node);
    m_wasWithoutSupply = m_wasWithoutSupply || bootUps.unasked > m_wanted.before.unasked;
    m_wasReset = m_wasReset || bootUps.all > m_wanted.before.all;
    if (const CanopenSnapshot::Node *heard = bus.heard(m_wanted.node))
        m_isDoubled = m_isDoubled || heard->isDoubled;
    if (m_isAsked || isEnded() || m_now < m_dueAt)
        return std::nullopt;
    const auto request = m_reading.next(bus);
    m_isAsked = request.has_value();
    return request;
}

void NodeCheck::answered(const SdoOutcome &outcome)
{
    if (!std::exchange(m_isAsked, false) || isEnded())
        return;
    m_reading.answered(outcome);
    if (!m_reading.isEnded())
        return;
    if (m_reading.result() == IdentityReading::Result::notSent)
        m_result = Result::notSent;
    else if (!m_isAtOld)
        takeAtNew(*m_reading.result());
    else
        m_result =
            m_reading.result() == IdentityReading::Result::read && m_reading.identity() == m_wanted.identity
                ? Result::atOldNumber
                : Result::silent;
}

void NodeCheck::takeAtNew(IdentityReading::Result result)
{
    if (result == IdentityReading::Result::noAnswer) {
        m_isAtOld = m_now >= *m_until;
        if (m_isAtOld && !hasOld())
            m_result = Result::silent;
        m_reading = IdentityReading(m_isAtOld && hasOld() ? *m_wanted.nodeBefore : m_wanted.node);
        m_dueAt = m_now + untilAskedAgain;
    } else if (m_isDoubled) {
        m_result = Result::doubled;
    } else if (result == IdentityReading::Result::notTold) {
        m_result = Result::notTold;
    } else {
        m_result = m_reading.identity() == m_wanted.identity ? Result::found : Result::isOther;
    }
}

} // namespace codewheel::canopen
