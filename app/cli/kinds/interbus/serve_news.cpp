// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/serve_news.h"

#include "cli/call/texts.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

QString counts(const ServedClient &client)
{
    return sentence(
        CommandLine::tr("%1 requests, %2 of them refused; %3 writes"),
        {QString::number(client.requests), QString::number(client.refused), QString::number(client.writes)});
}

} // namespace

QString newsLine(const ClientNews &news)
{
    switch (news.what) {
    case ClientNews::What::came:
        return sentence(CommandLine::tr("%1 is connected."), {news.client.address}) + u'\n';
    case ClientNews::What::left:
        return sentence(CommandLine::tr("%1 has left: %2."), {news.client.address, counts(news.client)}) +
               u'\n';
    case ClientNews::What::refused:
        break;
    }
    return sentence(CommandLine::tr("%1 was refused: there are as many clients as can be served."),
                    {news.client.address}) +
           u'\n';
}

QString servedText(const ServedClients &clients)
{
    return sentence(CommandLine::tr("Clients: %1, and %2 that were refused. %3."),
                    {QString::number(clients.everCame()), QString::number(clients.refusedConnections()),
                     counts(clients.total())}) +
           u'\n';
}

QJsonObject servedJson(const ServedClients &clients)
{
    const ServedClient total = clients.total();
    const auto number = [](std::uint64_t count) { return static_cast<qint64>(count); };
    return {{QStringLiteral("clients"), number(clients.everCame())},
            {QStringLiteral("refusedClients"), number(clients.refusedConnections())},
            {QStringLiteral("requests"), number(total.requests)},
            {QStringLiteral("refusedRequests"), number(total.refused)},
            {QStringLiteral("writes"), number(total.writes)}};
}

} // namespace codewheel
