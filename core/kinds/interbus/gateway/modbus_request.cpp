// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/modbus_request.h"

#include <algorithm>

namespace codewheel {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint8_t exceptionBit = 0x80;

enum Function : std::uint8_t {
    readHolding = 3,
    readInput = 4,
    writeOne = 6,
    writeSeveral = 16,
    maskWrite = 22,
    readAndWrite = 23,
};

struct Layout
{
    Function function;
    std::size_t fixed; // bytes without the registers to write, but with their byte count
    bool hasByteCount; // as the last of these
};

constexpr Layout layouts[] = {
    {readHolding, 5, false}, {readInput, 5, false}, {writeOne, 5, false},
    {writeSeveral, 6, true}, {maskWrite, 7, false}, {readAndWrite, 10, true},
};

const Layout *layoutOf(Bytes pdu)
{
    const auto found =
        std::ranges::find_if(layouts, [&](const Layout &layout) { return layout.function == pdu.front(); });
    return found == std::end(layouts) ? nullptr : found;
}

bool isWithin(int count, int most)
{
    return count >= 1 && count <= most;
}

// Its count of registers, their count of bytes, and they themselves, from `place`.
bool takeWritten(ModbusRequest &request, Bytes pdu, std::size_t place, int most)
{
    const int count = registerAt(pdu, place);
    if (!isWithin(count, most) || pdu[place + 2] != 2 * count)
        return false;
    for (std::size_t at = place + 3; at < pdu.size(); at += 2)
        request.changes.push_back({registerAt(pdu, at)});
    return true;
}

bool take(ModbusRequest &request, Bytes pdu)
{
    switch (request.function) {
    case readHolding:
    case readInput:
        request.area = request.function == readInput ? RegisterArea::input : RegisterArea::holding;
        request.readFirst = registerAt(pdu, 1);
        request.readCount = registerAt(pdu, 3);
        return isWithin(request.readCount, modbus_limit::readRegisters);
    case writeOne:
        request.writeFirst = registerAt(pdu, 1);
        request.changes = {{registerAt(pdu, 3)}};
        return true;
    case writeSeveral:
        request.writeFirst = registerAt(pdu, 1);
        return takeWritten(request, pdu, 3, modbus_limit::writtenRegisters);
    case maskWrite: // (now AND first) OR (second AND NOT first)
        request.writeFirst = registerAt(pdu, 1);
        request.changes = {{registerAt(pdu, 5), static_cast<Register>(~registerAt(pdu, 3))}};
        return true;
    default:
        request.readFirst = registerAt(pdu, 1);
        request.readCount = registerAt(pdu, 3);
        request.writeFirst = registerAt(pdu, 5);
        return isWithin(request.readCount, modbus_limit::readRegisters) &&
               takeWritten(request, pdu, 7, modbus_limit::writtenWithRead);
    }
}

void append(ModbusBytes &bytes, Register value)
{
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
}

// Of an answer to a write: address and count, address and value, or address and both masks.
std::size_t confirmedBytes(std::uint8_t function)
{
    return function == maskWrite ? 7 : 5;
}

} // namespace

std::optional<std::size_t> modbusRequestLength(Bytes begin)
{
    if (begin.empty())
        return std::nullopt;
    const Layout *layout = layoutOf(begin);
    if (layout == nullptr)
        return 0;
    if (!layout->hasByteCount)
        return layout->fixed;
    if (begin.size() < layout->fixed)
        return std::nullopt;
    return layout->fixed + begin[layout->fixed - 1];
}

std::size_t modbusAnswerLength(Bytes begin)
{
    if (begin.size() < 2)
        return 0;
    if ((begin[0] & exceptionBit) != 0)
        return 2;
    const Layout *layout = layoutOf(begin);
    if (layout == nullptr)
        return 0;
    const bool isRead =
        layout->function == readHolding || layout->function == readInput || layout->function == readAndWrite;
    return isRead ? 2U + begin[1] : confirmedBytes(layout->function);
}

tl::expected<ModbusRequest, ModbusException> ModbusRequest::parse(Bytes pdu)
{
    if (pdu.empty() || layoutOf(pdu) == nullptr)
        return tl::unexpected(ModbusException::illegalFunction);
    ModbusRequest request{.function = pdu.front()};
    if (modbusRequestLength(pdu) != pdu.size() || !take(request, pdu))
        return tl::unexpected(ModbusException::illegalValue);
    return request;
}

ModbusBytes modbusAnswer(Bytes request, const std::vector<Register> &read)
{
    if (read.empty())
        return {request.begin(),
                request.begin() + static_cast<std::ptrdiff_t>(confirmedBytes(request.front()))};
    ModbusBytes answer{request.front(), static_cast<std::uint8_t>(2 * read.size())};
    for (const Register value : read)
        append(answer, value);
    return answer;
}

ModbusBytes modbusAnswer(Bytes request, ModbusException exception)
{
    const std::uint8_t function = request.empty() ? std::uint8_t{0} : request.front();
    return {static_cast<std::uint8_t>(function | exceptionBit), static_cast<std::uint8_t>(exception)};
}

} // namespace codewheel
