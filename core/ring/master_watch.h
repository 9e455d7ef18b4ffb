// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/message.h"
#include "ring/master_status.h"

#include <map>
#include <set>
#include <vector>

namespace codewheel {

// Turns what the master says into messages when a fault appears, is located or goes, when a segment is
// switched, and, at most once a minute and segment, when data cycles were faulty. Used by the runner after
// each cycle in which the status changed, so that what lasts one cycle is told.
class MasterWatch
{
public:
    // In the order of what happened; without time. `ring` has the numbers of status.devices.
    std::vector<Message> look(const MasterStatus &status, const std::vector<NodeId> &ring, Instant now);

    // After each cycle: the CRC errors that were held back until their minute was over.
    std::vector<Message> lookAtTime(Instant now);
    // As data cycles end: those that are held back still.
    std::vector<Message> lookAtRest(Instant now);

    // A service took the master to READY: that the fault does not show any more is no news of the fault.
    void leftByService() { m_before.state = MasterState::ready; }

    // The faults told so far were confirmed; those that go now were not merely cleared.
    void confirmedByService();

private:
    void lookAtBus(const MasterStatus &status);
    bool isFaultSwitchedOff(const MasterStatus &status) const;
    void lookAtDevices(const MasterStatus &status, const std::vector<NodeId> &ring);
    void lookAtSegments(const MasterStatus &status, Instant now);
    void lookAtCrcErrors(const MasterStatus::Segment &segment, Instant now);
    void tellCrcErrors(const MasterStatus::Segment &segment, Instant now);

    struct Told
    {
        std::uint32_t crcErrors = 0;
        std::optional<Instant> at;
    };

    MasterStatus m_before;
    std::vector<int> m_off;            // segments, in the order they were switched off
    std::set<std::size_t> m_confirmed; // devices
    std::map<int, Told> m_told;        // by segment
    std::optional<Instant> m_due;      // when CRC errors that are held back are told
    std::vector<Message> m_messages;
};

} // namespace codewheel
