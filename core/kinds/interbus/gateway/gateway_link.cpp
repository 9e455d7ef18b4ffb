// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_link.h"

#include "kinds/interbus/gateway/gateway_device_state.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/gateway_texts.h"
#include "vocabulary/sentence.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

constexpr int exchangesInDoubt = 8; // after that a word is not up to date any more (assumed)

std::vector<Register> registersOf(const std::vector<RegisterBlock> &blocks, int first)
{
    const int end = blocks.empty() ? first : blocks.back().end();
    return std::vector<Register>(static_cast<std::size_t>(end - first));
}

} // namespace

GatewayLink::GatewayLink(std::unique_ptr<RegisterPort> port, GatewaySettings settings,
                         const std::vector<GatewayDevice> &ring)
    : m_port(std::move(port))
    , m_settings(std::move(settings))
{
    for (const GatewayDevice &device : ring) {
        m_ring.push_back(device.participant);
        m_devices.push_back({WordGate(device.profile, device.participant.inWords, m_settings.copyTime),
                             WordGate(std::nullopt, device.participant.outWords, m_settings.copyTime)});
    }
}

GatewayLink::~GatewayLink() = default;

Result<RingStructure> GatewayLink::open()
{
    close();
    m_hurriesToZeros = false;
    if (m_ring.empty())
        return refuse(RefusalKind::badInput, GatewayRefusalId::gatewayHasNoDevices);
    auto map = GatewayMap::of(m_ring, m_settings);
    if (!map)
        return tl::unexpected(map.error());
    if (auto opened = m_port->open(); !opened)
        return tl::unexpected(opened.error());
    m_counter.connected();
    m_map = *std::move(map);
    m_readsBack = m_settings.readsBack;
    m_written = m_readsBack ? m_map->outBlocks() : std::vector<RegisterBlock>();
    (void)hasReconnected(); // OUT is read back next
    m_nextExchange = {};
    m_nextStatus = {};
    m_inRegisters = registersOf(m_map->inBlocks(), m_settings.inFirst);
    m_outRegisters = registersOf(m_map->outBlocks(), m_settings.outFirst);
    m_backRegisters = registersOf(m_map->readBackBlocks(), m_settings.outFirst);
    if (auto read = readIn().and_then([this] { return readStatus(); }); !read) {
        close();
        return tl::unexpected(read.error());
    }
    return m_ring;
}

void GatewayLink::close()
{
    m_port->close();
    m_counter.noticed(m_port->noticed());
    m_counter.closed(m_port->now());
    m_map.reset();
    m_told.reset();
    for (Device &device : m_devices) {
        device.isClaimed = false;
        device.in.forget();
        device.out.forget();
        device.own.forget();
        device.believed = false;
        device.doubts = 0;
    }
}

Result<void> GatewayLink::checkUse(std::size_t outWords, std::size_t inWords) const
{
    if (!m_map || outWords != m_devices.size() || inWords != m_devices.size())
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    return {};
}

// IN is read before OUT is written, so that it is never the reaction to the words of the same exchange,
// however slow the transactions are. Function 23 writes first, but reads at once.
Result<void> GatewayLink::exchange(std::span<const Word> out, std::span<Word> in)
{
    if (auto usable = checkUse(out.size(), in.size()); !usable)
        return usable;
    const QScopedValueRollback writing(m_isWriting, true);
    const Instant begun = m_port->now();
    m_mayBeSent = false;
    beginToRead();
    auto done = readStatus();
    if (done && !m_settings.writesWithRead)
        done = readIn().and_then([this] { return readDoubtfulAgain(); });
    if (done)
        done = m_readsBack ? checkIsOurs() : checkBlindWriting();
    if (done && m_hurriesToZeros)
        done = refuse(RefusalKind::stopped, RefusalId::cancelled);
    if (done)
        done = writeOut(out, Overwrites::ours);
    if (!done)
        return done;
    showIn(in);
    settle(begun);
    return done;
}

Result<void> GatewayLink::watch(std::span<Word> out, std::span<Word> in)
{
    if (auto usable = checkUse(out.size(), in.size()); !usable)
        return usable;
    const Instant begun = m_port->now();
    if (m_readsBack) {
        std::vector<Word> there;
        if (auto read = readOut(there); !read)
            return read;
        for (std::size_t i = 0; i < m_devices.size(); ++i)
            showOut(i, there[i], out[i]);
    }
    beginToRead();
    auto done = readIn().and_then([this] { return readDoubtfulAgain(); });
    if (done) {
        showIn(in);
        done = readStatus();
    }
    if (done)
        settle(begun);
    return done;
}

// They go out before anything is read.
Result<ProcessDataLink::ZerosSent> GatewayLink::sendZeros(std::span<Word> in)
{
    if (auto usable = checkUse(in.size(), in.size()); !usable)
        return tl::unexpected(usable.error());
    const QScopedValueRollback writing(m_isWriting, true);
    const Instant begun = m_port->now();
    m_hurriesToZeros = false;
    beginToRead();
    claimAll();
    auto done = writeZeros();
    if (done && !m_settings.writesWithRead)
        done = readIn().map([this] { countDoubts(); });
    if (!done)
        return tl::unexpected(done.error());
    showIn(in);
    settle(begun);
    m_nextStatus = {};
    (void)readStatus(); // whether there is a ring for them
    if (!m_readsBack)
        return ZerosSent();
    auto there = areZerosThere();
    if (there && there->areThere == false) // their answer may have been a late one, to a write of before
        there = writeZeros().and_then([this] { return areZerosThere(); });
    return there;
}

std::vector<QString> GatewayLink::outPlaces() const
{
    std::vector<QString> places;
    const auto map = GatewayMap::of(m_ring, m_settings);
    for (std::size_t i = 0; map && i < map->devices(); ++i)
        places.push_back(map->out(i).count == 0
                             ? QString()
                             : sentence(GatewayTexts::tr("register %1", "the first of a device"),
                                        {QString::number(map->out(i).first)}));
    return places;
}

LinkFigures GatewayLink::figuresNow()
{
    m_counter.noticed(m_port->noticed());
    return m_counter.counted();
}

// An exchange is what elsewhere is a bus cycle: with the time the ring takes to react.
void GatewayLink::settle(Instant begun)
{
    m_counter.noticed(m_port->noticed());
    m_counter.exchanged(m_port->now());
    m_nextExchange = std::max(begun + m_settings.pollInterval, m_port->now() + m_settings.reactionDelay);
    m_hasExchanged = true;
}

bool GatewayLink::isUpToDate(std::size_t device) const
{
    const Device &its = m_devices[device];
    if (m_told && m_told->stands())
        return false;
    return !m_map || m_map->in(device).count == 0 || (its.in.hasWord() && its.doubts < exchangesInDoubt);
}

std::optional<Instant> GatewayLink::age(std::size_t device) const
{
    if (isDoubtful(device))
        return std::nullopt;
    return m_map && m_map->in(device).count > 0 ? now() - m_devices[device].in.readAt() : Instant{};
}

// A bus that is stopped exchanges nothing, so nothing would ever have to be waited for.
void GatewayLink::wait(Instant until)
{
    const bool hasExchanged = std::exchange(m_hasExchanged, false);
    if (m_map && now() < m_nextExchange)
        m_port->wait(std::min(until, m_nextExchange));
    else if (!m_map || !hasExchanged)
        m_port->wait(until);
}

} // namespace codewheel
