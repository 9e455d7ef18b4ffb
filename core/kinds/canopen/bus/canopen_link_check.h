// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/check_outcome.h"
#include "can/can_link.h"
#include "kinds/canopen/bus/other_master.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "kinds/canopen/protocol/nmt.h"

#include <QCoreApplication>

#include <array>
#include <atomic>
#include <optional>
#include <vector>

namespace codewheel {

enum class CanopenLinkStep : std::uint8_t {
    opened,  // the adapter, to listen
    traffic, // frames come in, and no errors
    node,    // is heard
};

// What a step of CanopenLinkCheck found.
struct CanopenLinkFinding
{
    CanopenLinkStep step = CanopenLinkStep::opened;
    CanopenAddress address{}; // of a node; 0: of all that are heard
    CheckOutcome outcome = CheckOutcome::skipped;
    QString sentence{};
    std::optional<Refusal> why{}; // of an adapter that cannot be opened

    friend bool operator==(const CanopenLinkFinding &, const CanopenLinkFinding &) = default;
};

// Tests a link to a CAN bus step by step: whether its adapter can be opened, whether frames come in, and
// which nodes are heard. It only listens: a node that tells nothing by itself is not heard. Each next() does
// one step, so its caller can show what was found so far; interrupt() ends a step that waits. Used by the
// connection page.
class CanopenLinkCheck
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenLinkCheck)

public:
    static constexpr Instant listens = std::chrono::seconds(3); // heartbeats come once a second

    // `link` must outlive this and is used by nobody else meanwhile. `rate`: of the bus, unless its adapter
    // tells, in Bd. `nodes`: that are planned; without any, all that are heard are one step.
    CanopenLinkCheck(CanLink &link, int rate, const std::vector<CanopenAddress> &nodes);
    ~CanopenLinkCheck(); // closes the link
    Q_DISABLE_COPY_MOVE(CanopenLinkCheck)

    bool isDone() const { return m_next == m_steps.size(); }
    CanopenLinkFinding next();
    void interrupt(); // skips what is left. Any thread

    static QString stepText(CanopenLinkStep step, CanopenAddress address); // "Adapter", "Node 5 (05h)"

private:
    // What a node has sent meanwhile.
    struct Heard
    {
        int frames = 0;
        std::optional<canopen::NmtState> state{};
    };

    CanopenLinkFinding open();
    CanopenLinkFinding listen();
    CanopenLinkFinding node(CanopenAddress address) const;
    QString heardText(CanopenAddress address) const;
    void take(const CanFrame &frame);
    CanopenLinkFinding told(CheckOutcome outcome, const QString &sentence) const;
    CanopenLinkFinding refused(const Refusal &why);

    CanLink &m_link;
    const int m_rate;
    std::vector<CanopenLinkFinding> m_steps; // not made yet
    std::size_t m_next = 0;
    bool m_isOver = false; // nothing further can be found out
    int m_frames = 0;
    int m_errors = 0;
    std::array<Heard, canopen::lastNode + 1> m_heard{};
    OtherMaster m_master{};
    std::atomic<bool> m_isStopped = false;
};

} // namespace codewheel
