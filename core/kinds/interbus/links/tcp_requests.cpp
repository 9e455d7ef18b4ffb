// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/links/tcp_requests.h"

#include <array>
#include <poll.h>
#include <sys/socket.h>

namespace codewheel {
namespace {

using std::chrono::steady_clock;

// Modbus Messaging on TCP/IP V1.0b, 3.1.3: transaction, protocol (0), length of what follows, unit.
constexpr std::size_t headerBytes = 7;
constexpr std::size_t lengthOfUnit = 1;
constexpr std::size_t shortestRequest = lengthOfUnit + 1;
constexpr std::size_t longestRequest = lengthOfUnit + 253;

void put(ModbusBytes &bytes, std::size_t number)
{
    bytes.push_back(static_cast<std::uint8_t>(number >> 8U));
    bytes.push_back(static_cast<std::uint8_t>(number & 0xFFU));
}

} // namespace

ModbusBytes TcpRequest::answer(const ModbusBytes &itsPdu) const
{
    ModbusBytes frame;
    put(frame, transaction);
    put(frame, 0);
    put(frame, lengthOfUnit + itsPdu.size());
    frame.push_back(static_cast<std::uint8_t>(unit));
    frame.insert(frame.end(), itsPdu.begin(), itsPdu.end());
    return frame;
}

std::optional<TcpRequest> TcpRequests::next()
{
    steady_clock::time_point until = steady_clock::now() + m_patience.idle;
    bool isWithin = false;
    while (true) {
        if (!m_received.empty() && !std::exchange(isWithin, true))
            until = steady_clock::now() + m_patience.halfRequest;
        if (m_received.size() >= headerBytes) {
            const std::size_t length = registerAt(m_received, 4);
            if (registerAt(m_received, 2) != 0 || length < shortestRequest || length > longestRequest)
                return std::nullopt;
            const auto end = static_cast<std::ptrdiff_t>(headerBytes - lengthOfUnit + length);
            if (std::ssize(m_received) >= end) {
                TcpRequest request{registerAt(m_received, 0),
                                   m_received[headerBytes - 1],
                                   {m_received.begin() + headerBytes, m_received.begin() + end}};
                m_received.erase(m_received.begin(), m_received.begin() + end);
                return request;
            }
        }
        if (!receive(until))
            return std::nullopt;
    }
}

bool TcpRequests::receive(steady_clock::time_point until)
{
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - steady_clock::now());
    pollfd waited{m_descriptor, POLLIN, 0};
    if (left.count() < 0 || ::poll(&waited, 1, static_cast<int>(left.count())) != 1)
        return false;
    std::array<std::uint8_t, 512> bytes{};
    const auto count = ::recv(m_descriptor, bytes.data(), bytes.size(), 0);
    if (count <= 0)
        return false;
    m_received.insert(m_received.end(), bytes.begin(), bytes.begin() + count);
    return true;
}

} // namespace codewheel
