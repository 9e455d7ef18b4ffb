// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/sdo_frames.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

// The upper three bits of the first octet.
enum class ClientCommand : std::uint8_t {
    segment = 0x00,
    write = 0x20,
    read = 0x40,
    nextSegment = 0x60,
    abort = 0x80,
};

constexpr std::uint8_t inFrameBit = 0x02;
constexpr std::uint8_t sizeToldBit = 0x01;
constexpr std::uint8_t lastFlag = 0x01;
constexpr std::size_t numberAt = 4;

std::uint8_t octetOf(ClientCommand command, bool toggle = false)
{
    constexpr int clientToggleBit = 0x10;
    return static_cast<std::uint8_t>(static_cast<int>(command) | (toggle ? clientToggleBit : 0));
}

SdoOctets withObject(ClientCommand command, const SdoObject &object, std::uint32_t number = 0)
{
    SdoOctets octets{octetOf(command)};
    putNumber(std::span(octets).subspan(1, sizeof object.index), object.index);
    octets[3] = object.sub;
    putNumber(std::span(octets).subspan(numberAt), number);
    return octets;
}

} // namespace

SdoOctets sdoRead(const SdoObject &object)
{
    return withObject(ClientCommand::read, object);
}

SdoOctets sdoWrite(const SdoObject &object, Octets value)
{
    SdoOctets octets = withObject(ClientCommand::write, object, numberOf(value));
    octets[0] |= static_cast<std::uint8_t>((mostInFrame - value.size()) << 2 | inFrameBit | sizeToldBit);
    return octets;
}

SdoOctets sdoWriteBegins(const SdoObject &object, std::size_t size)
{
    SdoOctets octets = withObject(ClientCommand::write, object, static_cast<std::uint32_t>(size));
    octets[0] |= sizeToldBit;
    return octets;
}

SdoOctets sdoNextSegment(bool toggle)
{
    return {octetOf(ClientCommand::nextSegment, toggle)};
}

SdoOctets sdoSegment(Octets data, bool toggle, bool isLast)
{
    SdoOctets octets{octetOf(ClientCommand::segment, toggle)};
    octets[0] |=
        static_cast<std::uint8_t>((SdoFrame::mostOctets - data.size()) << 1 | (isLast ? lastFlag : 0));
    std::ranges::copy(data, octets.begin() + 1);
    return octets;
}

SdoOctets sdoAbort(const SdoObject &object, std::uint32_t code)
{
    return withObject(ClientCommand::abort, object, code);
}

} // namespace codewheel::canopen
