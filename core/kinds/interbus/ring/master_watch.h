// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/master_status.h"
#include "vocabulary/message.h"

#include <map>
#include <set>
#include <vector>

namespace codewheel {

// Turns what the master says into messages when a fault appears, is located or goes away, when a segment is
// switched, and, at most once a minute per segment, when data cycles were faulty. Used by the runner after
// each cycle in which the status changed, so that what lasts one cycle is reported.
class MasterWatch
{
public:
    // In the order of events; without time. `ring` has the numbers of status.devices.
    std::vector<Message> look(const MasterStatus &status, const std::vector<NodeId> &ring, Instant now);

    // After each cycle: the CRC errors held back until their minute was over.
    std::vector<Message> lookAtTime(Instant now);
    // When data cycles end: those still held back.
    std::vector<Message> lookAtRest(Instant now);

    // A service took the master to READY: that the fault no longer shows is not news about the fault.
    void leftByService() { m_before.state = MasterState::ready; }

    // The faults reported so far were confirmed; those that go away now were not merely cleared.
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
    std::optional<Instant> m_due;      // when the CRC errors held back are reported
    std::vector<Message> m_messages;
};

} // namespace codewheel
