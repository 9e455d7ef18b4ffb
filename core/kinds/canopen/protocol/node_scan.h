// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/node_identity.h"

#include <array>
#include <optional>
#include <vector>

namespace codewheel::canopen {

struct NodeScanTimes
{
    int rate = 125'000; // Bd
    int share = 30;     // % of the bus at most, answers counted
    Instant answer = std::chrono::milliseconds(100);
};

struct FoundNode
{
    int node = 0;
    std::optional<std::uint32_t> deviceType{};                               // 1000h
    std::array<std::optional<std::uint32_t>, NodeIdentity::size> identity{}; // 1018h:1 to 4

    friend bool operator==(const FoundNode &, const FoundNode &) = default;
};

// Reads 1000h and 1018h of the nodes 1 to 127 side by side, each number asked twice. An answer belongs to a
// node by its identifier, also when it is late. A node that is stopped does not answer. A state machine
// without I/O.
class NodeScan
{
public:
    NodeScan(const NodeScanTimes &times, Instant now);

    // To be sent now, given once.
    std::optional<CanFrame> next(Instant now);
    // The queue of the adapter is full: the frame that next() gave last has not been sent, and is given
    // again.
    void queueFull(Instant now);
    // Of the frame to this node. One that was refused is given again.
    void fate(int node, CanFate fate, Instant now);
    // Whether it is an SDO answer. What comes when all is done still counts.
    bool take(const CanFrame &frame, Instant now);
    std::optional<Instant> wakesAt() const; // empty: it is done

    bool isDone() const { return progress() == lastNode; }
    // Whether a frame was received: a full queue means wait, then.
    void hear(Instant now) { m_heardAt = now; }
    // Nothing goes out any more, as where nobody acknowledges.
    bool isStuck(Instant now) const;
    int progress() const; // numbers of which all is known, of 127
    std::vector<FoundNode> found() const;

private:
    struct Asked
    {
        std::size_t object = 0; // place in the list of what is read; behind it: all is known
        int times = 0;          // it was asked for
        Instant until{};        // the answer may come
        bool isThere = false;
        FoundNode found{};
    };

    static bool isSettled(const Asked &asked);
    void notSent(int node, Instant now);
    static void letPass(Asked &asked, Instant now);
    Asked *nextDue(Instant now);
    void occupy(Instant now);

    NodeScanTimes m_times;
    std::array<Asked, lastNode> m_nodes{};
    int m_lastAsked = 0; // number; 0: none, or it was sent for good
    Instant m_freeAt;    // for the next frame
    std::optional<Instant> m_stuckSince{};
    Instant m_heardAt{};
};

} // namespace codewheel::canopen
