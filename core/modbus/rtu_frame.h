// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modbus/modbus_request.h"

namespace codewheel {

// CRC-16 of a Modbus RTU frame (Modbus over Serial Line V1.02, 6.2.2); 0 over a frame with its CRC.
std::uint16_t modbusCrc(std::span<const std::uint8_t> bytes);

// With the unit before it and the CRC behind it.
ModbusBytes rtuFrame(int unit, const ModbusBytes &pdu);

// Finds requests in what comes over a serial line: a request ends with its last byte if its function tells
// how long it is, otherwise with the silence behind it. What is no request is skipped until the next
// silence.
class RtuRequests
{
public:
    static constexpr std::size_t longest = 256;

    struct Request
    {
        int unit = 0;
        ModbusBytes pdu{};
    };

    // Bytes came; at most one request is complete, since a client waits for the answer.
    std::optional<Request> take(std::span<const std::uint8_t> bytes);
    // Nothing came for a while.
    std::optional<Request> silence();
    // Whether silence() is to be told.
    bool isWithin() const { return m_isSkipping || !m_bytes.empty(); }
    bool isSkipping() const { return m_isSkipping; }

private:
    std::optional<Request> end();

    ModbusBytes m_bytes;
    bool m_isSkipping = false;
};

} // namespace codewheel
