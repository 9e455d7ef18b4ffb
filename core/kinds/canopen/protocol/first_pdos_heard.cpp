// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/first_pdos_heard.h"

#include "kinds/canopen/protocol/encoder_objects.h"
#include "kinds/canopen/protocol/nmt.h"

namespace codewheel::canopen {
namespace {

constexpr int firstPdo = 1;

} // namespace

void FirstPdosHeard::take(const CanFrame &frame)
{
    using Service = CobId::Service;
    if (frame.isError || frame.isRemote)
        return;
    const auto cob = frame.isExtended ? std::nullopt : CobId::of(frame.id);
    if (cob && (cob->service == Service::sdoRequest || cob->service == Service::sdoAnswer))
        return takeTransfer(*cob, frame);
    if (cob && cob->service == Service::errorControl) {
        const auto told = NodeState::read(frame.data());
        if (told && told->state == NmtState::bootUp && !told->toggle)
            m_mappings.restarted(cob->node);
        return;
    }
    if (const auto pdo = m_mappings.of(frame)) {
        if (pdo->mapping.number() == firstPdo)
            m_newest.insert_or_assign(pdo->node, frame);
    } else if (cob && cob->service == Service::tpdo && cob->number == firstPdo &&
               !m_mappings.isElsewhere(cob->node, firstPdo, frame.id)) {
        m_newest.insert_or_assign(cob->node, frame);
    }
}

// What came under the predefined identifier was of somebody else then.
void FirstPdosHeard::takeTransfer(const CobId &cob, const CanFrame &frame)
{
    const bool isAnswer = cob.service == CobId::Service::sdoAnswer;
    if (m_blocks.segment(cob.node, isAnswer, frame.data()))
        return;
    const auto sdo = isAnswer ? SdoFrame::answer(frame.data()) : SdoFrame::request(frame.data());
    if (!sdo)
        return;
    m_mappings.followSdo(cob.node, *sdo);
    const auto newest = m_newest.find(cob.node);
    if (newest != m_newest.end() && m_mappings.isElsewhere(cob.node, firstPdo, newest->second.id))
        m_newest.erase(newest);
}

const CanFrame *FirstPdosHeard::of(int node) const
{
    const auto newest = m_newest.find(node);
    if (newest == m_newest.end())
        return nullptr;
    const auto pdo = m_mappings.of(newest->second);
    const bool hasNoPosition = pdo && pdo->mapping.hasAllEntries() && !pdo->mapping.holds(object::position);
    return hasNoPosition ? nullptr : &newest->second;
}

} // namespace codewheel::canopen
