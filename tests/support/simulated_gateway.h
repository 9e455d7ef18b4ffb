// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "kinds/interbus/gateway/gateway_link.h"
#include "kinds/interbus/simulator/simulated_ring.h"

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <random>

namespace codewheel::test {

// A gateway in front of a simulated ring, in virtual time. It runs the ring by itself: a cycle each
// millisecond, with the OUT words it was given last. IN is in the input registers from 0, OUT in the holding
// registers from 0, high word first. Registers change one after the other, so a read that falls into an
// update gives torn words.
class SimulatedGateway
{
public:
    struct Ways
    {
        double tears = 0;        // of the words that change: how many a read finds torn
        Instant copyApart{};     // from the copy of the high register of a word to that of the low one
        Instant lag{};           // until a word that was written can be read back
        unsigned seed = 1;       // of the tears
        bool passesOver = false; // long times, in which nothing is read: only the shafts turn
    };

    explicit SimulatedGateway(std::shared_ptr<SimulatedRing> ring);
    SimulatedGateway(std::shared_ptr<SimulatedRing> ring, Ways ways);

    // What the ring has done until then.
    void passUntil(Instant now);
    Register read(RegisterArea area, int number);
    void write(int first, std::span<const Register> registers);
    int registers(RegisterArea area) const { return static_cast<int>(halvesOf(area).size()); }

    const std::vector<Word> &out() const { return m_out; } // as the ring gets it
    void setOut(std::size_t device, Word word);            // somebody else writes
    // Whether IN of the device was this word at some time since then, or the shaft came by there between two
    // cycles.
    bool wasIn(std::size_t device, Word word, Instant since) const;
    // After each write through a port.
    std::function<void()> written;
    int writes() const { return m_writes; }
    SimulatedRing &ring() { return *m_ring; }

private:
    struct Change
    {
        Instant at{};
        Word before = 0;
        Word word = 0;
    };
    // What a register shows.
    struct Half
    {
        std::size_t device = 0;
        bool isHigh = false;

        Register of(Word word) const { return static_cast<Register>(isHigh ? word >> 16 : word & 0xFFFF); }
        Word put(Register half, Word word) const
        {
            return isHigh ? Word{half} << 16 | (word & 0xFFFF) : (word & 0xFFFF'0000) | half;
        }
    };
    static constexpr std::size_t changesKept = 6'000;

    void cycle();
    bool isTorn();
    const std::vector<Half> &halvesOf(RegisterArea area) const
    {
        return area == RegisterArea::input ? m_inHalves : m_outHalves;
    }

    std::shared_ptr<SimulatedRing> m_ring;
    Ways m_ways;
    std::mt19937 m_random;
    std::vector<Half> m_inHalves; // by register
    std::vector<Half> m_outHalves;
    Instant m_now{};
    std::vector<Word> m_out;
    std::vector<Change> m_outChanges; // the last of each device
    std::vector<Word> m_in;
    std::vector<std::deque<Change>> m_inChanges;
    int m_writes = 0;
};

// A port to it; each transaction takes a while.
class SimulatedGatewayPort final : public RegisterPort
{
public:
    explicit SimulatedGatewayPort(std::shared_ptr<SimulatedGateway> gateway,
                                  Instant transaction = std::chrono::milliseconds(1))
        : m_gateway(std::move(gateway))
        , m_transaction(transaction)
    {}

    Result<void> open() override;
    void close() override { m_open = false; }
    Done read(RegisterArea area, int first, std::span<Register> to) override;
    Done write(int first, std::span<const Register> from) override;
    Done writeAndRead(int writeFirst, std::span<const Register> from, int readFirst,
                      std::span<Register> to) override;
    Instant now() const override;
    void wait(Instant until) override;
    void interrupt() override { m_interrupted = true; }
    QString name() const override { return QStringLiteral("gateway"); }

    // From now on by the computer's clock, for a bus with a thread. Before it is opened.
    void goByRealTime() { m_realSince = m_realSince.value_or(std::chrono::steady_clock::now()); }

private:
    Done begin(RegisterArea area, int end);

    std::shared_ptr<SimulatedGateway> m_gateway;
    Instant m_transaction;
    Instant m_now{}; // until it goes by real time
    std::optional<std::chrono::steady_clock::time_point> m_realSince{};
    bool m_open = false;
    std::atomic<bool> m_interrupted{false};
};

// The ring as a project describes it.
std::vector<GatewayDevice> gatewayDevices(const SimulatedRing &ring, const Catalog &catalog);

} // namespace codewheel::test
