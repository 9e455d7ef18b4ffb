// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/register_port.h"
#include "kinds/interbus/ring/link_figures.h"

#include <memory>

namespace codewheel {

// Counts for LinkFigures. Bus thread only.
class GatewayCounter
{
public:
    // A transaction that was sent at `begun`; `again`: because the one before failed.
    void transaction(const RegisterPort::Done &done, Instant begun, Instant now, bool again);
    void connected() { ++m_opened; }
    void noticed(const RegisterPort::Noticed &by);
    void torn(std::size_t words) { m_figures.tornWords += words; }
    void exchanged(Instant now);
    void closed(Instant now); // nothing is exchanged until it is open again
    void status(Register word) { m_figures.status = word; }

    // Newly made every now and then, as the window looks at them.
    std::shared_ptr<const LinkFigures> figures() const { return m_told; }
    LinkFigures counted() const; // until now

private:
    void show(Instant now);

    LinkFigures m_figures;
    std::uint64_t m_opened = 0;
    std::uint64_t m_renewals = 0;
    AnswerTimes m_roundTrips;
    std::shared_ptr<const LinkFigures> m_told = std::make_shared<const LinkFigures>();
    Instant m_toldAt{};
    Instant m_countedSince{};
    std::uint64_t m_countedFrom = 0; // exchanges
};

} // namespace codewheel
