// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/sdo_blocks.h"

namespace codewheel::canopen {
namespace {

constexpr std::size_t sdoFrameSize = 8;
constexpr std::uint8_t lastSegmentBit = 0x80;    // with the number of a segment, which is never 0
constexpr std::uint8_t uploadStarts = 0xA3;      // of the client
constexpr std::uint8_t blockAcknowledged = 0xA2; // of whoever receives

// Of the server; a bit says whether it checks a sum.
bool isDownloadTaken(std::uint8_t command)
{
    constexpr std::uint8_t sumBit = 0x04;
    constexpr std::uint8_t taken = 0xA0;
    return (command & ~sumBit) == taken;
}

} // namespace

std::optional<SdoBlockSegment> SdoBlocks::segment(int node, bool isAnswer, Octets frame)
{
    Transfer &transfer = m_transfers.at(static_cast<std::size_t>(node));
    if (frame.size() != sdoFrameSize)
        return std::nullopt;
    const int number = frame[0] & ~lastSegmentBit;
    const bool isOfSender = transfer.isUpload == isAnswer;
    if (!transfer.isUnderWay || !isOfSender || transfer.isLast || number != transfer.before + 1) {
        follow(transfer, isAnswer, frame);
        return std::nullopt;
    }
    transfer.before = number;
    transfer.isLast = (frame[0] & lastSegmentBit) != 0;
    return SdoBlockSegment{number, transfer.isLast};
}

void SdoBlocks::follow(Transfer &transfer, bool isAnswer, Octets frame)
{
    const std::uint8_t command = frame[0];
    const bool isOfReceiver = transfer.isUpload != isAnswer;
    if (transfer.isUnderWay && isOfReceiver && command == blockAcknowledged) {
        const bool isAll = transfer.isLast && frame[1] == transfer.before;
        transfer = {.isUnderWay = !isAll, .isUpload = transfer.isUpload};
    } else if (isAnswer && isDownloadTaken(command)) {
        transfer = {.isUnderWay = true};
    } else {
        transfer = {.isUnderWay = !isAnswer && command == uploadStarts, .isUpload = true};
    }
}

} // namespace codewheel::canopen
