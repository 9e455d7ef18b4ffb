// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/sdo.h"

#include <array>
#include <vector>

namespace codewheel::canopen {

// A read or a write of an object, from its request to its end, as it was heard: whoever asked.
struct SdoDialogue
{
    enum class End : std::uint8_t {
        answered,
        aborted,
        unanswered, // another request, or the end of the patience, came first
    };

    int node = 0;
    SdoObject object{};
    bool isWrite = false;
    End end = End::unanswered;
    std::vector<std::uint8_t> value{}; // written or read, the lowest octet first
    std::uint32_t abortCode = 0;
    bool isAbortedByClient = false;
    int frames = 0;
    Instant begun{};
    Instant ended{};

    // "Node 5: read 6004h:0 = 1388h = 5000 (1.2 ms)"
    QString text() const;
};

// Follows the transfers of all nodes on the predefined identifiers. Block transfers are left to their frames.
class SdoDialogues
{
public:
    static constexpr Instant patience{std::chrono::seconds(3)}; // SDO answers may take 1 s and more

    struct Taken
    {
        bool isPart = false; // the frame belongs to a dialogue
        std::vector<SdoDialogue> ended{};
    };

    // Each frame in turn.
    Taken take(const CanFrame &frame, Instant at);
    // Those for whose answer nobody waits any longer.
    std::vector<SdoDialogue> overdue(Instant now);

private:
    struct Open
    {
        bool isUnderWay = false;
        bool isInSegments = false;
        bool hasLastSegment = false; // of a write: its acknowledgement is the end
        SdoDialogue dialogue{};
    };

    static Taken request(Open &open, const SdoFrame &sdo, Instant at);
    static Taken answer(Open &open, const SdoFrame &sdo, Instant at);
    static bool endsWith(Open &open, const SdoFrame &answer);
    static SdoDialogue close(Open &open, SdoDialogue::End end, Instant at);

    std::array<Open, lastNode + 1> m_open{};
};

} // namespace codewheel::canopen
