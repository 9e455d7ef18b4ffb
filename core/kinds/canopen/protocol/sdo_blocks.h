// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/octets.h"

#include <array>
#include <cstdint>
#include <optional>

namespace codewheel::canopen {

struct SdoBlockSegment
{
    int number = 0; // 1 to 127, within its block
    bool isLast = false;
};

// Tells the data of block transfers (CiA 301, 7.2.4.3.9 on) from commands, which a frame by itself does not
// say: it follows the transfers of all nodes. Where a segment is missing it no longer knows.
class SdoBlocks
{
public:
    // Each frame of the service in turn. Empty: it is a command.
    std::optional<SdoBlockSegment> segment(int node, bool isAnswer, Octets frame);

private:
    struct Transfer
    {
        bool isUnderWay = false; // data is to come
        bool isUpload = false;   // of the server
        bool isLast = false;     // all was sent, and is to be acknowledged
        int before = 0;          // number of the segment before
    };
    static void follow(Transfer &transfer, bool isAnswer, Octets frame);

    std::array<Transfer, lastNode + 1> m_transfers{};
};

} // namespace codewheel::canopen
