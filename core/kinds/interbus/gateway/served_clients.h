// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_units.h"

#include <QString>

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace codewheel {

// A program that uses what a server offers, and what it has done so far.
struct ServedClient
{
    using Time = std::chrono::system_clock::time_point;
    struct Written
    {
        int unit = 0;
        ServedWord word;
        Time at;

        friend bool operator==(const Written &, const Written &) = default;
    };

    unsigned id = 0; // counts the clients of a server, from 1
    QString address; // "192.168.0.7:51234", "/dev/ttyUSB0"
    Time since;
    Time seen{};                      // its last request, or when it came
    std::optional<int> unit{};        // of its last request
    std::uint64_t requests = 0;       // all of them
    std::uint64_t writes = 0;         // those that changed a word
    std::uint64_t refused = 0;        // those answered with an exception
    std::optional<Written> written{}; // the last

    friend bool operator==(const ServedClient &, const ServedClient &) = default;
};

// How many came to a server, left it again, and were refused, so far.
struct ClientCounts
{
    std::uint64_t came = 0;
    std::uint64_t left = 0;
    std::uint64_t refused = 0;

    friend bool operator==(const ClientCounts &, const ClientCounts &) = default;
};

struct ClientNews
{
    enum class What : std::uint8_t { came, left, refused };

    What what = What::came;
    ServedClient client; // as it was then
};

// Who is connected to a server, for the threads that serve them, and for those who show it, which fetch it.
// Any thread; time is an argument.
class ServedClients
{
public:
    static constexpr std::size_t mostNews = 1'000; // until they are taken; those that come after are dropped

    explicit ServedClients(std::size_t most)
        : m_most(most)
    {}

    static constexpr std::chrono::seconds silent{5}; // without a request (assumed)

    // Its id; empty: it is refused, since there are as many as there may be.
    std::optional<unsigned> come(const QString &address, ServedClient::Time now);
    // Where there are: the one that gives way to a new one, which has left then. Of the address with the most
    // connections, it is the one that has been silent for longest; empty: none has been silent for that long.
    std::optional<unsigned> giveWay(ServedClient::Time now);
    void took(unsigned id, int unit, const ServedUnits::Answer &answer, ServedClient::Time now);
    void leave(unsigned id);

    std::vector<ServedClient> clients() const; // in the order in which they came
    std::uint64_t everCame() const;
    std::uint64_t refusedConnections() const;
    // What was written last to each unit, by whomever.
    std::map<int, ServedClient::Written> writtenTo() const;
    ServedClient total() const; // what all of them have done, those who left included
    std::vector<ClientNews> takeNews();
    // And what the counts are with them, those that were dropped included.
    std::pair<std::vector<ClientNews>, ClientCounts> takeNewsAndCounts();
    ClientCounts counts() const;

private:
    ClientCounts countsNow() const; // under the lock
    void tell(ClientNews::What what, const ServedClient &client);
    static void count(ServedClient &client, const ServedUnits::Answer &answer);

    const std::size_t m_most;
    mutable std::mutex m_mutex; // guards everything below
    std::vector<ServedClient> m_clients;
    ServedClient m_total;
    std::map<int, ServedClient::Written> m_writtenTo;
    unsigned m_everCame = 0;
    std::uint64_t m_refused = 0;
    std::vector<ClientNews> m_news;
};

} // namespace codewheel
