// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <random>
#include <thread>

namespace codewheel::test {

// A relay for Modbus/TCP on loopback that does to each message what a bad network does: it delays, drops,
// cuts and doubles it, or closes the connection. Messages are told apart by the length in their header.
class FaultyRelay
{
public:
    enum Kind { delayed, dropped, cut, doubled, closed, kinds };

    FaultyRelay(int serverPort, unsigned seed);
    ~FaultyRelay();
    FaultyRelay(const FaultyRelay &) = delete;
    FaultyRelay &operator=(const FaultyRelay &) = delete;

    int port() const { return m_port; }
    // From now on so many of a thousand messages suffer each of these.
    void make(int ofThousand) { m_ofThousand = ofThousand; }
    int made(Kind kind) const { return m_made[kind]; }

private:
    void serve(const std::stop_token &stop);
    void relay(int client, const std::stop_token &stop);
    bool pass(int from, int to);
    bool isMade(Kind kind);

    int m_serverPort;
    std::mt19937 m_random;
    std::atomic<int> m_ofThousand{0};
    std::atomic<int> m_made[kinds]{};
    int m_listener = -1;
    int m_port = 0;
    std::jthread m_thread;
};

} // namespace codewheel::test
