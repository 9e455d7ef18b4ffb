// SPDX-License-Identifier: GPL-3.0-or-later
#include "modbus/rtu_frame.h"

#include <utility>

namespace codewheel {
namespace {

constexpr std::size_t unitBytes = 1;
constexpr std::size_t crcBytes = 2;
constexpr std::size_t shortest = unitBytes + 1 + crcBytes;

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

ModbusBytes rtuFrame(int unit, const ModbusBytes &pdu)
{
    ModbusBytes frame{static_cast<std::uint8_t>(unit)};
    frame.insert(frame.end(), pdu.begin(), pdu.end());
    const unsigned crc = modbusCrc(frame);
    frame.push_back(static_cast<std::uint8_t>(crc & 0xFFU)); // low byte first
    frame.push_back(static_cast<std::uint8_t>(crc >> 8U));
    return frame;
}

std::optional<RtuRequests::Request> RtuRequests::take(std::span<const std::uint8_t> bytes)
{
    if (m_isSkipping)
        return std::nullopt;
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    const auto pdu = std::span(m_bytes).subspan(unitBytes);
    const auto length = modbusRequestLength(pdu);
    if (m_bytes.size() > longest || (length && *length > 0 && pdu.size() >= *length + crcBytes))
        return end();
    return std::nullopt;
}

std::optional<RtuRequests::Request> RtuRequests::silence()
{
    if (std::exchange(m_isSkipping, false) || m_bytes.empty())
        return std::nullopt;
    auto request = end();
    m_isSkipping = false;
    return request;
}

std::optional<RtuRequests::Request> RtuRequests::end()
{
    const ModbusBytes frame = std::exchange(m_bytes, {});
    if (frame.size() < shortest || frame.size() > longest || modbusCrc(frame) != 0) {
        m_isSkipping = true;
        return std::nullopt;
    }
    return Request{frame.front(), {frame.begin() + unitBytes, frame.end() - crcBytes}};
}

} // namespace codewheel
