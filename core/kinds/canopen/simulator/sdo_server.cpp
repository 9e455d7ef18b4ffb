// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/sdo_server.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

using SdoKind = SdoFrame::Kind;

constexpr std::size_t mostExpedited = 4;
constexpr std::size_t mostOctetsTaken = 64; // longer than any object

SdoServer::Answer answerWith(std::uint8_t command, SdoObject object, std::uint32_t number = 0)
{
    SdoServer::Answer answer{command, static_cast<std::uint8_t>(object.index),
                             static_cast<std::uint8_t>(object.index >> 8), object.sub};
    for (std::size_t i = 0; i < mostExpedited; ++i)
        answer[mostExpedited + i] = static_cast<std::uint8_t>(number >> 8 * i);
    return answer;
}

std::uint8_t toggled(std::uint8_t command, bool toggle)
{
    return static_cast<std::uint8_t>(command | (toggle ? 0x10 : 0));
}

} // namespace

std::optional<SdoServer::Answer> SdoServer::answer(Octets frame, SdoObjects &objects)
{
    const auto request = SdoFrame::request(frame);
    if (!request)
        return std::nullopt;
    switch (request->kind) {
    case SdoKind::read:
    case SdoKind::write:
    case SdoKind::writeBegins:
        return begin(*request, objects);
    case SdoKind::readSegment:
    case SdoKind::segment:
        return segment(*request, objects);
    case SdoKind::abort:
        m_transfer.reset();
        return std::nullopt;
    default:
        return abort({static_cast<std::uint16_t>(numberOf(frame.subspan(1, 2))), frame[3]},
                     AbortCode::command);
    }
}

SdoServer::Answer SdoServer::begin(const SdoFrame &request, SdoObjects &objects)
{
    m_transfer.reset();
    const SdoObject object = request.object;
    if (request.kind == SdoKind::write) {
        const auto written = objects.write(object, request.data(), request.isSizeTold);
        return written ? answerWith(0x60, object) : abort(object, written.error());
    }
    if (request.kind == SdoKind::writeBegins) {
        m_transfer = Transfer{.object = object, .size = request.wholeSize};
        return answerWith(0x60, object);
    }
    const auto value = objects.read(object);
    if (!value)
        return abort(object, value.error());
    if (!value->empty() && value->size() <= mostExpedited) {
        const std::size_t unused = mostExpedited - value->size();
        return answerWith(static_cast<std::uint8_t>(0x43 | unused << 2), object, numberOf(*value));
    }
    m_transfer = Transfer{.object = object, .isRead = true, .octets = *value};
    return answerWith(0x41, object, static_cast<std::uint32_t>(value->size()));
}

SdoServer::Answer SdoServer::segment(const SdoFrame &request, SdoObjects &objects)
{
    const bool isRead = request.kind == SdoKind::readSegment;
    if (!m_transfer || m_transfer->isRead != isRead)
        return abort({}, AbortCode::command);
    if (request.toggle != m_transfer->toggle)
        return abort(m_transfer->object, AbortCode::toggle);
    return isRead ? nextSegment() : takeSegment(request, objects);
}

SdoServer::Answer SdoServer::nextSegment()
{
    const auto left = Octets(m_transfer->octets).subspan(m_transfer->sent);
    const auto now = left.first(std::min(left.size(), SdoFrame::mostOctets));
    const bool isLast = now.size() == left.size();
    const std::size_t unused = SdoFrame::mostOctets - now.size();
    Answer answer{toggled(static_cast<std::uint8_t>(unused << 1 | (isLast ? 1 : 0)), m_transfer->toggle)};
    std::ranges::copy(now, answer.begin() + 1);
    m_transfer->sent += now.size();
    m_transfer->toggle = !m_transfer->toggle;
    if (isLast)
        m_transfer.reset();
    return answer;
}

SdoServer::Answer SdoServer::takeSegment(const SdoFrame &request, SdoObjects &objects)
{
    Transfer &transfer = *m_transfer;
    const Octets data = request.data();
    transfer.octets.insert(transfer.octets.end(), data.begin(), data.end());
    if (transfer.octets.size() > transfer.size.value_or(mostOctetsTaken))
        return abort(transfer.object, AbortCode::tooLong);
    const Answer answer{toggled(0x20, request.toggle)};
    transfer.toggle = !transfer.toggle;
    if (!request.isLast)
        return answer;
    if (transfer.size && transfer.octets.size() < *transfer.size)
        return abort(transfer.object, AbortCode::tooShort);
    const auto written = objects.write(transfer.object, transfer.octets, true);
    if (!written)
        return abort(transfer.object, written.error());
    m_transfer.reset();
    return answer;
}

SdoServer::Answer SdoServer::abort(SdoObject object, AbortCode code)
{
    m_transfer.reset();
    return answerWith(0x80, object, static_cast<std::uint32_t>(code));
}

} // namespace codewheel::canopen
