// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <random>
#include <thread>
#include <vector>

namespace codewheel::test {

// A relay for Modbus/TCP on loopback that does to each message what bad networks and gateways do: it delays,
// drops, cuts and doubles it, sends it in pieces, with a byte that belongs to nothing, or again and again for
// a while, or closes the connection. Messages are told apart by the length in their header.
class FaultyRelay
{
public:
    enum Kind { delayed, dropped, cut, doubled, closed, inPieces, strayByte, flood, kinds };

    FaultyRelay(int serverPort, unsigned seed);
    ~FaultyRelay();
    FaultyRelay(const FaultyRelay &) = delete;
    FaultyRelay &operator=(const FaultyRelay &) = delete;

    int port() const { return m_port; }
    // From now on so many of a thousand messages suffer each of these.
    void make(int ofThousand) { m_ofThousand = ofThousand; }
    // Each message in two parts, behind its header.
    void splitAll() { m_splitsAll = true; }
    int made(Kind kind) const { return m_made[kind]; }

private:
    void serve(const std::stop_token &stop);
    void relay(int client, const std::stop_token &stop);
    bool pass(int from, int to, bool isAnswer);
    bool isMade(Kind kind);
    bool sendOn(int to, const std::vector<std::uint8_t> &message);

    int m_serverPort;
    std::mt19937 m_random;
    std::atomic<int> m_ofThousand{0};
    std::atomic<bool> m_splitsAll{false};
    std::atomic<int> m_made[kinds]{};
    int m_listener = -1;
    int m_port = 0;
    std::jthread m_thread;
};

} // namespace codewheel::test
