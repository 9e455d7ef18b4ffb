// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/sdo.h"

#include "vocabulary/hex.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

using Kind = SdoFrame::Kind;

constexpr std::size_t frameSize = 8;
constexpr std::size_t valueBegin = 4;
constexpr std::size_t longestValue = 4;
constexpr std::uint8_t toggleBit = 0x10;

// By the upper three bits of the first octet.
constexpr std::array requestKinds{Kind::segment, Kind::write, Kind::read,  Kind::readSegment,
                                  Kind::abort,   Kind::block, Kind::block, Kind::unknown};
constexpr std::array answerKinds{Kind::segment, Kind::segmentWritten, Kind::value, Kind::written,
                                 Kind::abort,   Kind::block,          Kind::block, Kind::unknown};

void takeOctets(SdoFrame &sdo, Octets octets)
{
    std::ranges::copy(octets, sdo.octets.begin());
    sdo.size = octets.size();
}

// Octet 0: bit 1 the value is in the frame, bit 0 its size is told, bits 3 and 2 how many octets have none.
void takeValue(SdoFrame &sdo, Octets frame, Kind withSegments)
{
    const bool isInFrame = (frame[0] & 0x02) != 0;
    sdo.isSizeTold = (frame[0] & 0x01) != 0;
    if (isInFrame) {
        const std::size_t unused = sdo.isSizeTold ? frame[0] >> 2 & 0x03 : 0;
        takeOctets(sdo, frame.subspan(valueBegin, longestValue - unused));
        return;
    }
    sdo.kind = withSegments;
    if (sdo.isSizeTold)
        sdo.wholeSize = numberOf(frame.subspan(valueBegin));
}

// Octet 0: bit 0 it is the last one, bits 3 to 1 how many octets have no data.
void takeSegment(SdoFrame &sdo, Octets frame)
{
    sdo.isLast = (frame[0] & 0x01) != 0;
    const std::size_t unused = frame[0] >> 1 & 0x07;
    takeOctets(sdo, frame.subspan(1, SdoFrame::mostOctets - unused));
}

// Bits that mean nothing are 0. Data of a block transfer, which begins with a count, would be taken for
// commands otherwise.
bool hasOnlyItsBits(Kind kind, std::uint8_t command)
{
    constexpr std::uint8_t bitsOfCommand = 0x1F;
    const int bits = command & bitsOfCommand;
    switch (kind) {
    case Kind::read:
    case Kind::written:
    case Kind::abort:
        return bits == 0;
    case Kind::readSegment:
    case Kind::segmentWritten:
        return (bits & ~toggleBit) == 0;
    case Kind::write:
    case Kind::value:
        return (bits & toggleBit) == 0;
    default:
        return true;
    }
}

SdoFrame read(Octets frame, Kind kind, Kind withSegments)
{
    SdoFrame sdo{.kind = kind, .toggle = (frame[0] & toggleBit) != 0};
    if (!hasOnlyItsBits(kind, frame[0])) {
        sdo.kind = Kind::unknown;
        return sdo;
    }
    const SdoObject object{static_cast<std::uint16_t>(numberOf(frame.subspan(1, 2))), frame[3]};
    switch (kind) {
    case Kind::segment:
        takeSegment(sdo, frame);
        break;
    case Kind::write:
    case Kind::value:
        takeValue(sdo, frame, withSegments);
        sdo.object = object;
        break;
    case Kind::abort:
        sdo.abortCode = numberOf(frame.subspan(valueBegin));
        sdo.object = object;
        break;
    case Kind::read:
    case Kind::written:
        sdo.object = object;
        break;
    default:
        break;
    }
    return sdo;
}

} // namespace

QString SdoObject::text() const
{
    return QStringLiteral("%1:%2").arg(hexNumber(index, 4)).arg(sub);
}

std::optional<SdoFrame> SdoFrame::request(Octets frame)
{
    if (frame.size() != frameSize)
        return std::nullopt;
    return read(frame, requestKinds[frame[0] >> 5], Kind::writeBegins);
}

std::optional<SdoFrame> SdoFrame::answer(Octets frame)
{
    if (frame.size() != frameSize)
        return std::nullopt;
    SdoFrame sdo = read(frame, answerKinds[frame[0] >> 5], Kind::valueBegins);
    sdo.isAnswer = true;
    return sdo;
}

} // namespace codewheel::canopen
