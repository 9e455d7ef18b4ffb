// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/modbus_request.h"

#include <span>

namespace codewheel {

// Finds answers in what comes over a line with Modbus RTU: a frame is as long as its function says, and its
// CRC fits (MODBUS over Serial Line V1.02, 2.5.1). What is before, behind or between them is passed over:
// bytes of a driver that is switched late, noise, the echo of an adapter that hears what it sends.
class RtuAnswers
{
public:
    struct Frame
    {
        int unit = 0;
        ModbusBytes pdu{};
    };

    // This frame goes out now, and may come back as an echo. What came before it is dropped.
    void begin(ModbusBytes request);
    void take(std::span<const std::uint8_t> bytes);
    // The next one that is complete, of whatever unit; to be asked until there is none.
    std::optional<Frame> next();
    // Bytes have come that belong to no frame so far.
    bool isWithin() const { return !m_bytes.empty(); }

    // Over all requests.
    std::uint64_t strayBytes() const { return m_strayBytes; }
    std::uint64_t echoes() const { return m_echoes; }

private:
    void drop(std::size_t bytes, std::size_t strays);
    bool mayBeEcho(std::span<const std::uint8_t> bytes) const;

    ModbusBytes m_request; // that may still come back
    ModbusBytes m_bytes;
    std::uint64_t m_strayBytes = 0;
    std::uint64_t m_echoes = 0;
};

} // namespace codewheel
