// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/sdo_transfer.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

using AnswerKind = SdoFrame::Kind;

bool fitsInFrame(const std::vector<std::uint8_t> &value)
{
    return !value.empty() && value.size() <= mostInFrame;
}

} // namespace

SdoTransfer::SdoTransfer(const SdoObject &object, std::optional<std::vector<std::uint8_t>> value)
    : m_object(object)
    , m_isWrite(value.has_value())
    , m_value(std::move(value).value_or(std::vector<std::uint8_t>()))
{}

Octets SdoTransfer::nextPiece() const
{
    const Octets rest = Octets(m_value).subspan(static_cast<std::size_t>(m_segments) * SdoFrame::mostOctets);
    return rest.first(std::min(rest.size(), SdoFrame::mostOctets));
}

SdoOctets SdoTransfer::request() const
{
    if (m_isInSegments && !m_isWrite)
        return sdoNextSegment(m_toggle);
    if (m_isInSegments) {
        const Octets piece = nextPiece();
        return sdoSegment(piece, m_toggle, piece.data() + piece.size() == m_value.data() + m_value.size());
    }
    if (!m_isWrite)
        return sdoRead(m_object);
    return fitsInFrame(m_value) ? sdoWrite(m_object, m_value) : sdoWriteBegins(m_object, m_value.size());
}

SdoTransfer::Taken SdoTransfer::take(const SdoFrame &answer)
{
    if (answer.kind == AnswerKind::abort && answer.object == m_object) {
        m_outcome = {.kind = SdoOutcome::Kind::aborted, .abortCode = answer.abortCode};
        return Taken::yes;
    }
    if (!m_isInSegments)
        return takeFirst(answer);
    return m_isWrite ? takeAcknowledgement(answer) : takeSegment(answer);
}

SdoTransfer::Taken SdoTransfer::takeFirst(const SdoFrame &answer)
{
    if (answer.object != m_object)
        return Taken::no;
    if (m_isWrite) {
        if (answer.kind != AnswerKind::written)
            return Taken::no;
        m_isInSegments = !fitsInFrame(m_value);
        return m_isInSegments ? Taken::yes : end(SdoOutcome::Kind::written);
    }
    if (answer.kind == AnswerKind::value) {
        m_value.assign(answer.data().begin(), answer.data().end());
        end(SdoOutcome::Kind::read);
        m_outcome->isSizeTold = answer.isSizeTold;
        return Taken::yes;
    }
    if (answer.kind != AnswerKind::valueBegins)
        return Taken::no;
    m_isInSegments = true;
    m_wholeSize = answer.wholeSize;
    return m_wholeSize > mostSegments * SdoFrame::mostOctets ? giveUp(abortMemory) : Taken::yes;
}

SdoTransfer::Taken SdoTransfer::takeSegment(const SdoFrame &answer)
{
    if (answer.kind != AnswerKind::segment)
        return Taken::no;
    if (answer.toggle != m_toggle)
        return wrongToggle(answer.octets == m_before);
    m_value.insert(m_value.end(), answer.data().begin(), answer.data().end());
    if (m_wholeSize && m_value.size() > *m_wholeSize)
        return giveUp(abortTooLong);
    if (answer.isLast)
        return m_wholeSize && m_value.size() < *m_wholeSize ? giveUp(abortTooShort)
                                                            : end(SdoOutcome::Kind::read);
    if (++m_segments >= mostSegments)
        return giveUp(abortMemory);
    m_before = answer.octets;
    m_toggle = !m_toggle;
    return Taken::yes;
}

SdoTransfer::Taken SdoTransfer::takeAcknowledgement(const SdoFrame &answer)
{
    if (answer.kind != AnswerKind::segmentWritten)
        return Taken::no;
    if (answer.toggle != m_toggle)
        return wrongToggle(true);
    ++m_segments;
    m_toggle = !m_toggle;
    const std::size_t sent = static_cast<std::size_t>(m_segments) * SdoFrame::mostOctets;
    return sent >= m_value.size() ? end(SdoOutcome::Kind::written) : Taken::yes;
}

SdoTransfer::Taken SdoTransfer::wrongToggle(bool isDoubled)
{
    return m_segments > 0 && isDoubled ? Taken::doubled : giveUp(abortToggle);
}

SdoTransfer::Taken SdoTransfer::end(SdoOutcome::Kind kind)
{
    m_outcome = {.kind = kind};
    if (!m_isWrite)
        m_outcome->value = std::move(m_value);
    return Taken::yes;
}

SdoTransfer::Taken SdoTransfer::giveUp(std::uint32_t code)
{
    m_outcome = {.kind = SdoOutcome::Kind::aborted, .abortCode = code, .isOwnAbort = true};
    return Taken::yes;
}

} // namespace codewheel::canopen
