// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "kinds/canopen/protocol/octets.h"

#include <QString>

#include <optional>

namespace codewheel::canopen {

enum class NmtCommand : std::uint8_t {
    start = 0x01,
    stop = 0x02,
    preOperational = 0x80,
    resetNode = 0x81,
    resetCommunication = 0x82,
};
constexpr bool isReset(NmtCommand command)
{
    return command == NmtCommand::resetNode || command == NmtCommand::resetCommunication;
}

struct NmtRequest
{
    NmtCommand command = NmtCommand::start; // may be one that is not among them
    int node = 0;                           // 0: all

    static std::optional<NmtRequest> read(Octets data); // empty: it does not have two bytes
    CanFrame frame() const;
    QString text() const; // "start node 5"
};

enum class NmtState : std::uint8_t {
    bootUp = 0x00, // not known yet
    stopped = 0x04,
    operational = 0x05,
    preOperational = 0x7F,
};

// What a node tells of itself: heartbeat, or the answer to guarding, whose toggle bit changes each time.
struct NodeState
{
    NmtState state = NmtState::bootUp; // may be one that is not among them
    bool toggle = false;

    static std::optional<NodeState> read(Octets data); // empty: it does not have one byte
    QString text() const;                              // "operational"
};

} // namespace codewheel::canopen
