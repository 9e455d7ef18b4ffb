// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "kinds/canopen/protocol/octets.h"

#include <optional>

namespace codewheel::canopen {

// CiA 305. An answer has the command of its request, except selected and identified.
enum class LssCommand : std::uint8_t {
    switchAll = 0x04, // 0: waiting, 1: configuration; no answer
    configureNode = 0x11,
    configureRate = 0x13,
    activateRate = 0x15,
    store = 0x17,
    selectVendor = 0x40, // the four of the identity, the last one is answered
    selectProduct = 0x41,
    selectRevision = 0x42,
    selectSerial = 0x43,
    selected = 0x44,
    identifyVendor = 0x46, // and the ranges of revision and serial number, up to 4Bh
    identifySerialHigh = 0x4B,
    identifyUnconfigured = 0x4C,
    identified = 0x4F,
    identifiedUnconfigured = 0x50,
    fastScan = 0x51,
    inquireVendor = 0x5A,
    inquireProduct = 0x5B,
    inquireRevision = 0x5C,
    inquireSerial = 0x5D,
    inquireNode = 0x5E,
};

struct LssFrame
{
    LssCommand command = LssCommand::switchAll; // may be one that is not among them
    std::uint32_t number = 0;                   // the four octets behind it
    std::uint8_t bit = 0;                       // of a fast scan: the last bit that counts; 80h: who is there
    std::uint8_t word = 0;                      // of a fast scan: which of the identity, 0 to 3
    std::uint8_t nextWord = 0;                  // of a fast scan: which one is asked for next

    // The two octets behind the command: a node, a table and a place in it, or how it went.
    std::uint8_t first() const { return static_cast<std::uint8_t>(number); }
    std::uint8_t second() const { return static_cast<std::uint8_t>(number >> 8); }

    static std::optional<LssFrame> read(Octets data); // empty: it does not have eight bytes
    CanFrame request() const;
};

} // namespace codewheel::canopen
