// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/modbus_request.h"

#include <QByteArray>

namespace codewheel {

// CRC-16 of a Modbus RTU frame (Modbus over Serial Line V1.02, 6.2.2); 0 over a frame with its CRC.
std::uint16_t modbusCrc(std::span<const std::uint8_t> bytes);

// The same bytes as a line gives and takes them (ByteLink).
std::span<const std::uint8_t> rtuOctets(const QByteArray &bytes);
QByteArray rtuByteArray(const ModbusBytes &octets);

// With the unit before it and the CRC behind it.
ModbusBytes rtuFrame(int unit, const ModbusBytes &pdu);

// Finds requests in what comes over a serial line: a request ends with its last byte if its function tells
// how long it is, otherwise with the silence behind it. Whatever else is on the line, such as the answers of
// other units, is passed over.
class RtuRequests
{
public:
    static constexpr std::size_t longest = 256;

    struct Request
    {
        int unit = 0;
        ModbusBytes pdu{};
    };

    void take(std::span<const std::uint8_t> bytes);
    // The next one that is complete; to be asked until there is none.
    std::optional<Request> next();
    // Nothing came for a while: what has come until now is complete, or will never be.
    std::optional<Request> silence();
    bool isWithin() const { return !m_bytes.empty(); } // silence() is to be told

private:
    ModbusBytes m_bytes;
};

} // namespace codewheel
