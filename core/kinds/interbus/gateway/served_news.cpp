// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/served_news.h"

#include "kinds/interbus/gateway/offer_messages.h"

#include <utility>

namespace codewheel {
namespace {

std::int64_t shownCount(std::uint64_t count)
{
    return static_cast<std::int64_t>(count);
}

Message messageOf(const ClientNews &news)
{
    const ServedClient &client = news.client;
    switch (news.what) {
    case ClientNews::What::came:
        return {.id = OfferMessageId::clientCame, .arguments = {client.address}};
    case ClientNews::What::left:
        return {.id = OfferMessageId::clientLeft,
                .arguments = {client.address, shownCount(client.requests), shownCount(client.writes)}};
    case ClientNews::What::refused:
        break;
    }
    return {
        .severity = Severity::attention, .id = OfferMessageId::clientRefused, .arguments = {client.address}};
}

Message summaryOf(const ClientCounts &more)
{
    return {.severity = more.refused > 0 ? Severity::attention : Severity::information,
            .id = OfferMessageId::clientsPassed,
            .arguments = {shownCount(more.came), shownCount(more.left), shownCount(more.refused)}};
}

} // namespace

// The news are bounded, so those that were not told one by one are counted by the server's own counts.
std::vector<Message> ServedNews::take(ServedClients &clients, Instant now)
{
    const auto [news, counts] = clients.takeNewsAndCounts();
    if (m_began && now - *m_began >= period) {
        m_began.reset();
        if (std::exchange(m_inPeriod, 0) == mostAlone && counts != m_told)
            return {summarize(counts, now)};
    }
    std::vector<Message> messages;
    for (const ClientNews &one : news) {
        if (m_inPeriod == mostAlone)
            break;
        m_began = m_began.value_or(now);
        ++m_inPeriod;
        count(one.what);
        messages.push_back(messageOf(one));
    }
    return messages;
}

// If many go on coming, the next summary comes after another period.
Message ServedNews::summarize(const ClientCounts &counts, Instant now)
{
    const ClientCounts before = std::exchange(m_told, counts);
    m_began = now;
    m_inPeriod = 1;
    return summaryOf({.came = counts.came - before.came,
                      .left = counts.left - before.left,
                      .refused = counts.refused - before.refused});
}

void ServedNews::count(ClientNews::What what)
{
    ++(what == ClientNews::What::came   ? m_told.came
       : what == ClientNews::What::left ? m_told.left
                                        : m_told.refused);
}

} // namespace codewheel
