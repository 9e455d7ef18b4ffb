// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/pdo_mappings_heard.h"
#include "kinds/canopen/protocol/sdo_blocks.h"

#include <map>

namespace codewheel::canopen {

// The newest TPDO1 of each node that may hold its position: by the identifier that the node was heard to
// tell, or else by the predefined one.
class FirstPdosHeard
{
public:
    void take(const CanFrame &frame);
    // Null: none was heard, or its mapping was, and has no position.
    const CanFrame *of(int node) const;

private:
    void takeTransfer(const CobId &cob, const CanFrame &frame);

    PdoMappingsHeard m_mappings;
    SdoBlocks m_blocks;
    std::map<int, CanFrame> m_newest;
};

} // namespace codewheel::canopen
