// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/finder/gateway_rtu_traffic.h"

#include <algorithm>

namespace codewheel {
namespace {

using Octets = std::span<const std::uint8_t>;

constexpr std::size_t unitSize = 1;
constexpr std::size_t crcSize = 2;
constexpr std::uint8_t exceptionMark = 0x80;
constexpr int functionReadHolding = 3;
constexpr int functionReadInput = 4;

// Of an answer that tells its length; 0: none does.
std::size_t answerLength(Octets pdu)
{
    if (pdu.size() < 2)
        return 0;
    if ((pdu[0] & exceptionMark) != 0)
        return (pdu[0] & ~exceptionMark) <= 23 && pdu[1] >= 1 && pdu[1] <= 11 ? 2 : 0;
    const bool isRead = pdu[0] == functionReadHolding || pdu[0] == functionReadInput;
    return isRead && pdu[1] > 0 && pdu[1] % 2 == 0 && pdu[1] <= 2 * modbus_limit::readRegisters ? 2U + pdu[1]
                                                                                                : 0;
}

bool isFrame(Octets bytes, std::size_t pduLength)
{
    const std::size_t whole = unitSize + pduLength + crcSize;
    return pduLength > 0 && bytes.size() >= whole && bytes[0] <= modbus_limit::lastSerialUnit &&
           modbusCrc(bytes.first(whole)) == 0;
}

// The length of the frame that these bytes begin with; 0: they begin with none.
std::size_t frameLength(Octets bytes)
{
    if (bytes.size() <= unitSize + 1)
        return 0;
    const Octets pdu = bytes.subspan(unitSize);
    for (const std::size_t length : {modbusRequestLength(pdu).value_or(0), answerLength(pdu)})
        if (isFrame(bytes, length))
            return unitSize + length + crcSize;
    return 0;
}

} // namespace

int rtuFramesIn(const QByteArray &bytes)
{
    int frames = 0;
    for (Octets rest = rtuOctets(bytes); !rest.empty();) {
        const std::size_t length = frameLength(rest);
        frames += length > 0 ? 1 : 0;
        rest = rest.subspan(std::max<std::size_t>(length, 1));
    }
    return frames;
}

std::optional<RtuAnswer> rtuAnswerIn(const QByteArray &bytes, int unit, int function)
{
    constexpr std::size_t wholeAnswer = longestRtuAnswer;
    constexpr std::size_t wholeException = 5;
    for (Octets rest = rtuOctets(bytes); rest.size() >= wholeException; rest = rest.subspan(1)) {
        if (rest[0] != unit)
            continue;
        const qsizetype begin = bytes.size() - static_cast<qsizetype>(rest.size());
        if (rest.size() >= wholeAnswer && rest[1] == function && rest[2] == 2 &&
            modbusCrc(rest.first(wholeAnswer)) == 0)
            return RtuAnswer{0, static_cast<Register>(rest[3] << 8U | rest[4]), begin, wholeAnswer};
        if (rest[1] == (static_cast<unsigned>(function) | exceptionMark) &&
            modbusCrc(rest.first(wholeException)) == 0)
            return RtuAnswer{rest[2], 0, begin, wholeException};
    }
    return std::nullopt;
}

} // namespace codewheel
