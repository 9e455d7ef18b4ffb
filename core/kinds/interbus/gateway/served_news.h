// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_clients.h"
#include "vocabulary/message.h"

namespace codewheel {

// What the user is told of the clients of a server: each that comes, leaves or is refused, as long as they
// are few; of many in a short time only how many, once that time is over. Time is an argument.
class ServedNews
{
public:
    static constexpr std::size_t mostAlone = 8; // messages in a period
    static constexpr std::chrono::seconds period{10};

    // What there is to say now.
    std::vector<Message> take(ServedClients &clients, Instant now);

private:
    Message summarize(const ClientCounts &counts, Instant now);
    void count(ClientNews::What what);

    std::optional<Instant> m_began; // the period; empty: nothing has come since the last one
    std::size_t m_inPeriod = 0;
    ClientCounts m_told;
};

} // namespace codewheel
