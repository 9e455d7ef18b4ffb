// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/served_clients.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

// "192.168.0.7" of "192.168.0.7:51234".
QString hostOf(const QString &address)
{
    return address.left(std::max<qsizetype>(address.lastIndexOf(u':'), 0));
}

} // namespace

std::optional<unsigned> ServedClients::come(const QString &address, ServedClient::Time now)
{
    const std::scoped_lock lock(m_mutex);
    if (m_clients.size() >= m_most) {
        ++m_refused;
        tell(ClientNews::What::refused, {.address = address, .since = now});
        return std::nullopt;
    }
    m_clients.push_back({.id = ++m_everCame, .address = address, .since = now, .seen = now});
    tell(ClientNews::What::came, m_clients.back());
    return m_everCame;
}

std::optional<unsigned> ServedClients::giveWay(ServedClient::Time now)
{
    const std::scoped_lock lock(m_mutex);
    if (m_clients.size() < m_most)
        return std::nullopt;
    std::map<QString, int> connections;
    for (const ServedClient &client : m_clients)
        ++connections[hostOf(client.address)];
    const auto rank = [&](const ServedClient &client) {
        return std::pair(-connections[hostOf(client.address)], client.seen);
    };
    std::optional<ServedClient> leaving;
    for (const ServedClient &client : m_clients)
        if (now - client.seen >= silent && (!leaving || rank(client) < rank(*leaving)))
            leaving = client;
    if (!leaving)
        return std::nullopt;
    tell(ClientNews::What::left, *leaving);
    std::erase_if(m_clients, [&](const ServedClient &client) { return client.id == leaving->id; });
    return leaving->id;
}

void ServedClients::took(unsigned id, int unit, const ServedUnits::Answer &answer, ServedClient::Time now)
{
    const std::scoped_lock lock(m_mutex);
    count(m_total, answer);
    if (answer.written)
        m_writtenTo.insert_or_assign(unit, ServedClient::Written{unit, *answer.written, now});
    const auto client = std::ranges::find(m_clients, id, &ServedClient::id);
    if (client == m_clients.end())
        return;
    count(*client, answer);
    client->unit = unit;
    client->seen = now;
    if (answer.written)
        client->written = ServedClient::Written{unit, *answer.written, now};
}

void ServedClients::count(ServedClient &client, const ServedUnits::Answer &answer)
{
    ++client.requests;
    client.refused += answer.isException ? 1 : 0;
    client.writes += answer.written ? 1 : 0;
}

void ServedClients::leave(unsigned id)
{
    const std::scoped_lock lock(m_mutex);
    const auto client = std::ranges::find(m_clients, id, &ServedClient::id);
    if (client == m_clients.end())
        return;
    tell(ClientNews::What::left, *client);
    m_clients.erase(client);
}

std::vector<ServedClient> ServedClients::clients() const
{
    const std::scoped_lock lock(m_mutex);
    return m_clients;
}

ClientCounts ServedClients::counts() const
{
    const std::scoped_lock lock(m_mutex);
    return countsNow();
}

ClientCounts ServedClients::countsNow() const
{
    return {.came = m_everCame, .left = m_everCame - m_clients.size(), .refused = m_refused};
}

std::uint64_t ServedClients::everCame() const
{
    const std::scoped_lock lock(m_mutex);
    return m_everCame;
}

std::uint64_t ServedClients::refusedConnections() const
{
    const std::scoped_lock lock(m_mutex);
    return m_refused;
}

std::map<int, ServedClient::Written> ServedClients::writtenTo() const
{
    const std::scoped_lock lock(m_mutex);
    return m_writtenTo;
}

ServedClient ServedClients::total() const
{
    const std::scoped_lock lock(m_mutex);
    return m_total;
}

std::vector<ClientNews> ServedClients::takeNews()
{
    const std::scoped_lock lock(m_mutex);
    return std::exchange(m_news, {});
}

std::pair<std::vector<ClientNews>, ClientCounts> ServedClients::takeNewsAndCounts()
{
    const std::scoped_lock lock(m_mutex);
    return {std::exchange(m_news, {}), countsNow()};
}

void ServedClients::tell(ClientNews::What what, const ServedClient &client)
{
    if (m_news.size() < mostNews)
        m_news.push_back({what, client});
}

} // namespace codewheel
