// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/pdo_mapping.h"

#include <array>
#include <memory>
#include <unordered_map>
#include <vector>

namespace codewheel::canopen {

// What the nodes of a bus map into the PDOs that they send, as far as their own answers tell it: whoever
// reads or writes 18xxh and 1Axxh, it is heard. A node that starts anew may map something else: what was
// heard of it is forgotten.
class PdoMappingsHeard
{
public:
    struct Pdo
    {
        int node = 0;
        PdoMapping mapping;
    };

    // Each frame of the services in turn: transfers, and heartbeats.
    void followSdo(int node, const SdoFrame &sdo);
    void restarted(int node);
    // Whose frame this is, by the identifier that was heard. Null: not known.
    std::shared_ptr<const Pdo> of(const CanFrame &frame) const;
    // The node was heard to tell that this PDO of it is switched off, or has another identifier.
    bool isElsewhere(int node, int number, std::uint32_t identifier) const;

private:
    void take(int node, const SdoObject &object, Octets value);
    void sortByIdentifier();

    std::array<SdoFrame, lastNode + 1> m_asked{}; // last, of each node
    std::vector<std::shared_ptr<const Pdo>> m_pdos{};
    std::unordered_map<std::uint32_t, std::shared_ptr<const Pdo>> m_byIdentifier{}; // that are sent
};

} // namespace codewheel::canopen
