// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/link_check.h"
#include "can/can_link.h"
#include "kinds/canopen/bus/other_master.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "kinds/canopen/protocol/nmt.h"

#include <QCoreApplication>

#include <array>
#include <optional>
#include <vector>

namespace codewheel {

enum class CanopenLinkStep : std::uint8_t {
    opened,  // the adapter, to listen
    traffic, // frames come in, and no errors
    node,    // is heard
};

using CanopenLinkFinding = LinkFinding<CanopenLinkStep, CanopenAddress>;

// Tests a link to a CAN bus step by step: whether its adapter can be opened, whether frames come in, and
// which nodes are heard. It only listens: a node that tells nothing by itself is not heard. Used by the
// connection page.
class CanopenLinkCheck final : public LinkCheck<CanLink, CanopenLinkStep, CanopenAddress>
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenLinkCheck)

public:
    static constexpr Instant listens = std::chrono::seconds(3); // heartbeats come once a second

    // `rate`: of the bus, unless its adapter tells, in Bd. `nodes`: that are planned; without any, all that
    // are heard are one step.
    CanopenLinkCheck(CanLink &link, int rate, const std::vector<CanopenAddress> &nodes);

    static QString stepText(CanopenLinkStep step, CanopenAddress address); // "Adapter", "Node 5 (05h)"

private:
    CanopenLinkFinding found(CanopenLinkStep step, CanopenAddress address) override;
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

    const int m_rate;
    int m_frames = 0;
    int m_extended = 0; // among them
    int m_errors = 0;
    std::array<Heard, canopen::lastNode + 1> m_heard{};
    OtherMaster m_master{};
};

} // namespace codewheel
