// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/sdo_client.h"

#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/frames.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

constexpr int mostAttempts = 3;
constexpr std::size_t rememberedObjects = 8;
// A frame whose acknowledgement got lost is on the bus twice. So long the same object is not written again,
// or the second answer would confirm what has not arrived.
constexpr Instant doubledFrames = std::chrono::milliseconds(2);

} // namespace

SdoIdentifiers SdoIdentifiers::predefined(int node)
{
    return {.request = CobId{.service = CobId::Service::sdoRequest, .node = node}.identifier(),
            .answer = CobId{.service = CobId::Service::sdoAnswer, .node = node}.identifier()};
}

SdoClient::SdoClient(const SdoIdentifiers &identifiers)
    : m_identifiers(identifiers)
{}

bool SdoClient::isBusy() const
{
    return m_transfer || m_abort;
}

void SdoClient::begin(SdoRequest request, Instant now)
{
    m_request = std::move(request);
    m_transfer.emplace(m_request.object, m_request.value);
    m_outcome.reset();
    m_attempts = 0;
    m_isWaiting = false;
    m_dueAt = now;
}

std::optional<CanFrame> SdoClient::next(Instant now)
{
    std::erase_if(m_owed, [&](const Owed &owed) { return owed.until <= now; });
    if (m_isWaiting && now >= m_dueAt)
        timedOut(now);
    if (const auto abort = std::exchange(m_abort, std::nullopt)) {
        ++m_given;
        return frameOf(m_identifiers.request, *abort);
    }
    if (!m_transfer || m_isWaiting || now < quietUntil())
        return std::nullopt;
    if (!m_transfer->isInSegments())
        ++m_attempts;
    ++m_given;
    m_isWaiting = true;
    m_sentAt = now;
    m_dueAt = now + m_request.timeOut;
    return frameOf(m_identifiers.request, m_transfer->request());
}

// Only now the node has it, so the time for its answer begins.
void SdoClient::fate(std::uint64_t number, CanFate fate, Instant now)
{
    if (!m_isWaiting || number != m_given) {
        lateFate(number, fate, now);
        return;
    }
    if (fate != CanFate::refused) {
        m_dueAt = now + m_request.timeOut;
        return;
    }
    const bool isBegun = m_transfer->isInSegments();
    if (isBegun)
        m_abort = sdoAbort(m_request.object, abortTimeOut);
    end({.kind = isBegun ? SdoOutcome::Kind::noAnswer : SdoOutcome::Kind::notSent}, now);
}

// Of a frame that was given up while the queue of the adapter still held it.
void SdoClient::lateFate(std::uint64_t number, CanFate fate, Instant now)
{
    if (fate == CanFate::refused)
        std::erase_if(m_owed, [&](const Owed &owed) { return owed.isOnlyOne && owed.frame == number; });
    for (Owed &owed : m_owed)
        if (owed.isOnlyOne && owed.frame == number)
            owed.until = std::max(owed.until, now + m_request.timeOut);
}

void SdoClient::timedOut(Instant now)
{
    owe(now + m_request.timeOut, true);
    if (m_transfer->isInSegments())
        m_abort = sdoAbort(m_request.object, abortTimeOut);
    if (m_transfer->isWrite() || m_attempts == mostAttempts) {
        end({.kind = SdoOutcome::Kind::noAnswer}, now);
        return;
    }
    m_transfer.emplace(m_request.object, std::nullopt);
    m_isWaiting = false;
    m_dueAt = now;
}

void SdoClient::owe(Instant until, bool isOnlyOne)
{
    m_owed.push_back({m_request.object, m_transfer->isInSegments(), isOnlyOne, until, m_given});
}

// An attempt does not wait for the answers to those before it: they are of the same transfer.
bool SdoClient::isOwed(const Owed &owed) const
{
    return owed.isSegment || (m_attempts == 0 && owed.object == m_request.object);
}

Instant SdoClient::quietUntil() const
{
    Instant until = m_dueAt;
    for (const Owed &owed : m_owed)
        if (!m_transfer->isInSegments() && isOwed(owed))
            until = std::max(until, owed.until);
    return until;
}

bool SdoClient::take(const CanFrame &frame, Instant now)
{
    if (!isDataOf(frame, m_identifiers.answer))
        return false;
    const auto answer = SdoFrame::answer(frame.data());
    const bool isTooEarly = frame.time && *frame.time < m_sentAt; // it was underway when we asked
    const auto taken =
        answer && m_isWaiting && !isTooEarly ? m_transfer->take(*answer) : SdoTransfer::Taken::no;
    switch (taken) {
    case SdoTransfer::Taken::yes:
        settle(now);
        break;
    case SdoTransfer::Taken::doubled:
        ++m_lateAnswers;
        break;
    case SdoTransfer::Taken::no:
        count(answer);
        break;
    }
    return true;
}

void SdoClient::settle(Instant now)
{
    m_isWaiting = false;
    m_dueAt = now;
    const auto outcome = m_transfer->outcome();
    if (!outcome)
        return;
    if (outcome->isOwnAbort)
        m_abort = sdoAbort(m_request.object, outcome->abortCode);
    if (m_transfer->isWrite())
        owe(now + doubledFrames, false);
    else if (m_attempts > 1) // it may have been of an attempt before, and that of this one be still to come
        owe(m_sentAt + 2 * m_request.timeOut, true);
    end(*outcome, now);
}

void SdoClient::end(const SdoOutcome &outcome, Instant now)
{
    m_outcome = outcome;
    m_wasInSegments = m_transfer->isInSegments();
    m_before.push_back(m_request.object);
    if (m_before.size() > rememberedObjects)
        m_before.pop_front();
    m_transfer.reset();
    m_isWaiting = false;
    m_dueAt = now;
}

// What is not taken: late if it is of something that was asked for.
void SdoClient::count(const std::optional<SdoFrame> &answer)
{
    const bool isKnown = answer && answer->kind != SdoFrame::Kind::unknown;
    const bool isSegment = isKnown && !answer->namesObject();
    const auto owed = std::ranges::find_if(m_owed, [&](const Owed &each) {
        return isKnown && each.isSegment == isSegment && (isSegment || each.object == answer->object);
    });
    const bool isOfBefore =
        isSegment ? m_wasInSegments : isKnown && std::ranges::count(m_before, answer->object) != 0;
    const bool isOfThis = isKnown && m_transfer &&
                          (isSegment ? m_transfer->isInSegments() : answer->object == m_request.object);
    ++(owed != m_owed.end() || isOfBefore || isOfThis ? m_lateAnswers : m_foreignAnswers);
    if (owed != m_owed.end() && owed->isOnlyOne)
        m_owed.erase(owed);
}

std::optional<Instant> SdoClient::wakesAt() const
{
    if (m_abort)
        return m_dueAt;
    if (!m_transfer)
        return std::nullopt;
    return m_isWaiting ? m_dueAt : quietUntil();
}

void SdoClient::cancel(Instant now)
{
    if (!m_transfer)
        return;
    if (m_isWaiting)
        owe(now + m_request.timeOut, true);
    if (m_transfer->isInSegments())
        m_abort = sdoAbort(m_request.object, abortTimeOut);
    end({}, now);
    m_outcome.reset();
}

} // namespace codewheel::canopen
