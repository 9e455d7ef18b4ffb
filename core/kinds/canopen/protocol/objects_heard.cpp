// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/objects_heard.h"

#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/nmt.h"

namespace codewheel::canopen {
namespace {

constexpr int octetBits = 8;

std::vector<std::uint8_t> octetsOfMapped(const PdoValue &value)
{
    std::vector<std::uint8_t> octets;
    for (int bit = 0; bit < value.bits; bit += octetBits)
        octets.push_back(static_cast<std::uint8_t>(value.raw >> bit));
    return octets;
}

// What it is commanded is not what it has: 1010h does not become "save".
bool tellsNoValue(const SdoDialogue &dialogue)
{
    const bool isCommand = dialogue.isWrite && isNoValue(dialogue.object);
    return isCommand || dialogue.end == SdoDialogue::End::unanswered || dialogue.isAbortedByClient ||
           (dialogue.isWrite && dialogue.end == SdoDialogue::End::aborted);
}

} // namespace

std::vector<HeardObject> ObjectsHeard::take(const CanFrame &frame, bool isSent, Instant at)
{
    if (frame.isError || frame.isRemote)
        return {};
    const auto cob = frame.isExtended ? std::nullopt : CobId::of(frame.id);
    if (cob && cob->service == CobId::Service::errorControl) {
        const auto told = NodeState::read(frame.data());
        if (told && told->state == NmtState::bootUp && !told->toggle)
            m_mappings.restarted(cob->node);
        return {};
    }
    const bool isTransfer =
        cob && (cob->service == CobId::Service::sdoRequest || cob->service == CobId::Service::sdoAnswer);
    return isTransfer ? takeTransfer(*cob, frame, isSent, at) : takePdo(frame, at);
}

std::vector<HeardObject> ObjectsHeard::takeTransfer(const CobId &cob, const CanFrame &frame, bool isSent,
                                                    Instant at)
{
    const bool isAnswer = cob.service == CobId::Service::sdoAnswer;
    if (m_blocks.segment(cob.node, isAnswer, frame.data()))
        return {};
    if (const auto sdo = isAnswer ? SdoFrame::answer(frame.data()) : SdoFrame::request(frame.data()))
        m_mappings.followSdo(cob.node, *sdo);
    std::vector<HeardObject> heard;
    bool &isOurs = m_areOurs.at(static_cast<std::size_t>(cob.node));
    for (SdoDialogue &ended : m_dialogues.take(frame, at).ended)
        if (!tellsNoValue(ended))
            heard.push_back({.node = ended.node,
                             .object = ended.object,
                             .value = ended.end == SdoDialogue::End::answered ? std::move(ended.value)
                                                                              : std::vector<std::uint8_t>(),
                             .how = ended.isWrite ? HeardObject::How::written : HeardObject::How::answered,
                             .isOurs = isOurs,
                             .at = at});
    if (!isAnswer)
        isOurs = isSent;
    return heard;
}

std::vector<HeardObject> ObjectsHeard::takePdo(const CanFrame &frame, Instant at) const
{
    std::vector<HeardObject> heard;
    const auto pdo = m_node ? m_mappings.of(frame) : nullptr;
    if (!pdo || pdo->node != *m_node)
        return heard;
    for (const PdoValue &value : pdo->mapping.values(frame, [](const SdoObject &) { return PdoType(); }))
        heard.push_back({.node = pdo->node,
                         .object = value.object,
                         .value = octetsOfMapped(value),
                         .how = HeardObject::How::sent,
                         .at = at});
    return heard;
}

} // namespace codewheel::canopen
