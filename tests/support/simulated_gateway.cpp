// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/simulated_gateway.h"

#include "catalog/catalog.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel::test {
namespace {

using namespace std::chrono_literals;

constexpr Instant gatewayCycle = 1ms;
constexpr Instant cyclesBeforeLooking = 5ms; // and as many before that, when time is passed over

bool cameBy(Word before, Word after, Word word)
{
    constexpr Word noPosition = 0xE000'0000;
    constexpr Word furthestInACycle = 0x8000; // steps
    const auto [least, most] = std::minmax(before, after);
    return ((before | after) & noPosition) == 0 && most - least < furthestInACycle && word >= least &&
           word <= most;
}

} // namespace

SimulatedGateway::SimulatedGateway(std::shared_ptr<SimulatedRing> ring)
    : SimulatedGateway(std::move(ring), Ways{})
{}

SimulatedGateway::SimulatedGateway(std::shared_ptr<SimulatedRing> ring, Ways ways)
    : m_ring(std::move(ring))
    , m_ways(ways)
    , m_random(ways.seed)
    , m_out(m_ring->structure().size())
    , m_outChanges(m_out.size())
    , m_in(m_out.size())
    , m_inChanges(m_out.size())
{
    std::size_t device = 0;
    for (const RingDevice &participant : m_ring->structure()) {
        for (int word = participant.inWords; word > 0; --word)
            m_inHalves.push_back({device, word == 2});
        for (int word = participant.outWords; word > 0; --word)
            m_outHalves.push_back({device, word == 2});
        ++device;
    }
}

void SimulatedGateway::cycle()
{
    m_now += gatewayCycle;
    std::vector<Word> in(m_in.size());
    if (!m_ring->exchange(m_out, in))
        return;
    for (std::size_t i = 0; i < in.size(); ++i) {
        if (in[i] == m_in[i])
            continue;
        m_inChanges[i].push_back({m_now, m_in[i], in[i]});
        m_in[i] = in[i];
        if (m_inChanges[i].size() > changesKept)
            m_inChanges[i].pop_front();
    }
}

void SimulatedGateway::passUntil(Instant now)
{
    const Instant over = now - m_now - 2 * cyclesBeforeLooking;
    const Instant shaftsOnly = m_ways.passesOver && over > 0ms ? over : 0ms;
    const Instant until = now - cyclesBeforeLooking;
    while (shaftsOnly > 0ms && m_now + shaftsOnly + gatewayCycle <= until)
        cycle();
    if (shaftsOnly > 0ms) {
        m_ring->missCycles(std::chrono::floor<std::chrono::milliseconds>(shaftsOnly));
        m_now += shaftsOnly;
    }
    while (m_now + gatewayCycle <= now)
        cycle();
}

bool SimulatedGateway::isTorn()
{
    return m_ways.tears > 0 && std::uniform_real_distribution<>(0, 1)(m_random) < m_ways.tears;
}

Register SimulatedGateway::read(RegisterArea area, int number)
{
    const Half &half = halvesOf(area)[static_cast<std::size_t>(number)];
    if (area == RegisterArea::input) {
        const auto &changes = m_inChanges[half.device];
        const bool isNew = !changes.empty() && changes.back().at == m_now;
        const bool isCopiedLater =
            !half.isHigh && !changes.empty() && m_now - changes.back().at < m_ways.copyApart;
        return half.of(isCopiedLater || (isNew && isTorn()) ? changes.back().before : m_in[half.device]);
    }
    const Change &change = m_outChanges[half.device];
    const Instant since = m_now - change.at;
    const bool isOld = since < m_ways.lag || (since < m_ways.lag + gatewayCycle && isTorn());
    return half.of(change.at > 0ms && isOld ? change.before : m_out[half.device]);
}

void SimulatedGateway::setOut(std::size_t device, Word word)
{
    if (m_out[device] == word)
        return;
    m_outChanges[device] = {m_now, m_out[device], word};
    m_out[device] = word;
}

void SimulatedGateway::write(int first, std::span<const Register> registers)
{
    std::vector<Word> out = m_out;
    for (const Register one : registers) {
        const Half &half = m_outHalves[static_cast<std::size_t>(first++)];
        out[half.device] = half.put(one, out[half.device]);
    }
    for (std::size_t i = 0; i < out.size(); ++i)
        setOut(i, out[i]);
    ++m_writes;
    if (written)
        written();
}

bool SimulatedGateway::wasIn(std::size_t device, Word word, Instant since) const
{
    if (m_in[device] == word)
        return true;
    const auto &changes = m_inChanges[device];
    for (auto change = changes.rbegin(); change != changes.rend() && change->at >= since; ++change)
        if (change->before == word || cameBy(change->before, change->word, word))
            return true;
    return false;
}

RegisterPort::Done SimulatedGatewayPort::begin(RegisterArea area, int end)
{
    if (m_interrupted.exchange(false))
        return tl::unexpected(RegisterError{RegisterError::Kind::stopped, 0, {}});
    if (!m_open)
        return tl::unexpected(RegisterError{RegisterError::Kind::closed, 0, {}});
    wait(now() + m_transaction);
    m_gateway->passUntil(now());
    if (end > m_gateway->registers(area))
        return tl::unexpected(RegisterError{RegisterError::Kind::exception, 2, {}});
    return {};
}

Instant SimulatedGatewayPort::now() const
{
    if (!m_realSince)
        return m_now;
    return m_now + std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now() - *m_realSince);
}

void SimulatedGatewayPort::wait(Instant until)
{
    if (!m_realSince)
        m_now = std::max(m_now, until);
    while (m_realSince && now() < until && !m_interrupted)
        std::this_thread::sleep_for(std::min<Instant>(until - now(), 1ms));
}

Result<void> SimulatedGatewayPort::open()
{
    if (m_interrupted.exchange(false))
        return refuse(RefusalKind::stopped, RefusalId::cancelled);
    m_open = true;
    return {};
}

RegisterPort::Done SimulatedGatewayPort::read(RegisterArea area, int first, std::span<Register> to)
{
    auto begun = begin(area, first + static_cast<int>(to.size()));
    if (!begun)
        return begun;
    for (Register &one : to)
        one = m_gateway->read(area, first++);
    return {};
}

RegisterPort::Done SimulatedGatewayPort::write(int first, std::span<const Register> from)
{
    auto begun = begin(RegisterArea::holding, first + static_cast<int>(from.size()));
    if (begun)
        m_gateway->write(first, from);
    return begun;
}

RegisterPort::Done SimulatedGatewayPort::writeAndRead(int writeFirst, std::span<const Register> from,
                                                      int readFirst, std::span<Register> to)
{
    auto written = write(writeFirst, from);
    return written ? read(RegisterArea::holding, readFirst, to) : written;
}

std::vector<GatewayDevice> gatewayDevices(const SimulatedRing &ring, const Catalog &catalog)
{
    std::vector<GatewayDevice> devices;
    for (const RingDevice &participant : ring.structure()) {
        const auto *device = catalog.find(participant.deviceKey, participant.deviceCode);
        devices.push_back({participant, device ? std::optional(device->profile) : std::nullopt});
    }
    return devices;
}

} // namespace codewheel::test
