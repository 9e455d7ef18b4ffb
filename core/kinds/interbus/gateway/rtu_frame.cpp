// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/rtu_frame.h"

#include <utility>

namespace codewheel {
namespace {

constexpr std::size_t unitBytes = 1;
constexpr std::size_t crcBytes = 2;
constexpr std::size_t shortest = unitBytes + 1 + crcBytes;

using Bytes = std::span<const std::uint8_t>;

RtuRequests::Request requestOf(Bytes frame)
{
    const Bytes pdu = frame.subspan(unitBytes, frame.size() - unitBytes - crcBytes);
    return {frame.front(), {pdu.begin(), pdu.end()}};
}

// The frame of a request that these bytes begin with; empty: they do not.
Bytes frameAt(Bytes bytes)
{
    const auto length = modbusRequestLength(bytes.subspan(unitBytes));
    const std::size_t whole = unitBytes + length.value_or(0) + crcBytes;
    if (!length || *length == 0 || bytes.size() < whole || modbusCrc(bytes.first(whole)) != 0)
        return {};
    return bytes.first(whole);
}

} // namespace

std::uint16_t modbusCrc(std::span<const std::uint8_t> bytes)
{
    constexpr unsigned polynomial = 0xA001;
    unsigned crc = 0xFFFF;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1U) != 0 ? (crc >> 1U) ^ polynomial : crc >> 1U;
    }
    return static_cast<std::uint16_t>(crc);
}

std::span<const std::uint8_t> rtuOctets(const QByteArray &bytes)
{
    // NOLINTNEXTLINE(*-reinterpret-cast): the same bytes
    return {reinterpret_cast<const std::uint8_t *>(bytes.constData()),
            static_cast<std::size_t>(bytes.size())};
}

QByteArray rtuByteArray(const ModbusBytes &octets)
{
    // NOLINTNEXTLINE(*-reinterpret-cast): the same bytes
    return {reinterpret_cast<const char *>(octets.data()), static_cast<qsizetype>(octets.size())};
}

ModbusBytes rtuFrame(int unit, const ModbusBytes &pdu)
{
    ModbusBytes frame{static_cast<std::uint8_t>(unit)};
    frame.insert(frame.end(), pdu.begin(), pdu.end());
    const unsigned crc = modbusCrc(frame);
    frame.push_back(static_cast<std::uint8_t>(crc & 0xFFU)); // low byte first
    frame.push_back(static_cast<std::uint8_t>(crc >> 8U));
    return frame;
}

void RtuRequests::take(Bytes bytes)
{
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
}

std::optional<RtuRequests::Request> RtuRequests::next()
{
    for (std::size_t begin = 0; begin < m_bytes.size(); ++begin) {
        const Bytes frame = frameAt(Bytes(m_bytes).subspan(begin));
        if (frame.empty())
            continue;
        Request request = requestOf(frame);
        m_bytes.erase(m_bytes.begin(), m_bytes.begin() + static_cast<std::ptrdiff_t>(begin + frame.size()));
        return request;
    }
    if (m_bytes.size() > longest) // the first of them begin no request any more
        m_bytes.erase(m_bytes.begin(), m_bytes.end() - static_cast<std::ptrdiff_t>(longest));
    return std::nullopt;
}

std::optional<RtuRequests::Request> RtuRequests::silence()
{
    const ModbusBytes frame = std::exchange(m_bytes, {});
    if (frame.size() < shortest || modbusCrc(frame) != 0)
        return std::nullopt;
    return requestOf(frame);
}

} // namespace codewheel
