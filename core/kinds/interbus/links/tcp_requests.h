// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/modbus_request.h"

#include <chrono>
#include <deque>

namespace codewheel {

// A request over TCP: header (MBAP) with transaction and unit, and its PDU.
struct TcpRequest
{
    std::uint16_t transaction = 0;
    int unit = 0;
    ModbusBytes pdu{};

    ModbusBytes answer(const ModbusBytes &pdu) const; // with its header
};

// The requests that a client sends over a connected socket, one after the other. They are as long as their
// header says, whatever the function: so one that is not known can be refused, and the next is understood.
class TcpRequests
{
public:
    struct Patience
    {
        std::chrono::milliseconds halfRequest; // from its first byte to its last
        std::chrono::milliseconds idle;        // without a request
    };

    TcpRequests(int descriptor, Patience patience)
        : m_descriptor(descriptor)
        , m_patience(patience)
    {}

    // Waits for it; empty: the client has gone, has sent what is no Modbus, or took too long.
    std::optional<TcpRequest> next();

private:
    bool receive(std::chrono::steady_clock::time_point until);

    int m_descriptor;
    Patience m_patience;
    ModbusBytes m_received;
};

} // namespace codewheel
