// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/register_port.h"

#include <cstdint>
#include <optional>
#include <span>
#include <tl/expected.hpp>
#include <vector>

namespace codewheel {

// Codes of exceptions (Modbus Application Protocol V1.1b3, 7).
enum class ModbusException : std::uint8_t {
    illegalFunction = 1,
    illegalAddress = 2,
    illegalValue = 3,
    deviceFailure = 4,
    deviceBusy = 6,
    noSuchUnit = 11, // the gateway's target does not respond
};

using ModbusBytes = std::vector<std::uint8_t>;

// A number of 16 bits in a message: its high byte comes first.
inline Register registerAt(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return static_cast<Register>(bytes[at] << 8 | bytes[at + 1]);
}

// The request of a client, from its function code to its last data byte (PDU), as a server understands it:
// functions 3, 4, 6, 16, 22 and 23. Used by ServedUnits.
struct ModbusRequest
{
    // The bits of a register that are written.
    struct Change
    {
        Register value = 0;
        Register mask = 0xFFFF;
    };

    int function = 0;
    RegisterArea area = RegisterArea::holding; // to read
    int readFirst = 0;
    int readCount = 0; // 0: it reads nothing
    int writeFirst = 0;
    std::vector<Change> changes{}; // of as many holding registers

    // illegalFunction: another function; illegalValue: wrong counts, or of another length than they say.
    static tl::expected<ModbusRequest, ModbusException> parse(std::span<const std::uint8_t> pdu);
};

// The whole length of a request, from its first bytes; empty: they do not tell it yet; 0: never, since the
// function is none of ours.
std::optional<std::size_t> modbusRequestLength(std::span<const std::uint8_t> begin);

// The whole length of an answer, from its first bytes; 0: they do not tell it yet, or its function is none of
// ours.
std::size_t modbusAnswerLength(std::span<const std::uint8_t> begin);

// The answer to a request that was carried out: `read` is what it reads; writing is confirmed by what was
// asked.
ModbusBytes modbusAnswer(std::span<const std::uint8_t> request, const std::vector<Register> &read);
ModbusBytes modbusAnswer(std::span<const std::uint8_t> request, ModbusException exception);

} // namespace codewheel
