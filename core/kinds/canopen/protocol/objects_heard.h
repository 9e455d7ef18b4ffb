// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/pdo_mappings_heard.h"
#include "kinds/canopen/protocol/sdo_blocks.h"
#include "kinds/canopen/protocol/sdo_dialogues.h"

#include <array>
#include <vector>

namespace codewheel::canopen {

// What a node was heard to have in an object: it answered somebody, acknowledged what somebody wrote, or sent
// a PDO.
struct HeardObject
{
    enum class How : std::uint8_t {
        answered,
        written,
        sent, // in a PDO
    };

    int node = 0;
    SdoObject object{};
    std::vector<std::uint8_t> value{}; // the lowest octet first; empty: there is none, it was refused
    How how = How::answered;
    bool isOurs = false; // we have asked, or written
    Instant at{};
};

// Listens to the transfers of all nodes, and to the PDOs of one.
class ObjectsHeard
{
public:
    void setNodeOfPdos(std::optional<int> node) { m_node = node; }
    // Each frame in turn; `isSent`: by us.
    std::vector<HeardObject> take(const CanFrame &frame, bool isSent, Instant at);

private:
    std::vector<HeardObject> takeTransfer(const CobId &cob, const CanFrame &frame, bool isSent, Instant at);
    std::vector<HeardObject> takePdo(const CanFrame &frame, Instant at) const;

    std::optional<int> m_node;
    SdoBlocks m_blocks;
    SdoDialogues m_dialogues;
    PdoMappingsHeard m_mappings;
    std::array<bool, lastNode + 1> m_areOurs{}; // the requests to each node
};

} // namespace codewheel::canopen
