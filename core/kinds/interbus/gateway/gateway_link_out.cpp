// SPDX-License-Identifier: GPL-3.0-or-later
// OUT on a gateway: reading it back, and writing it.
#include "kinds/interbus/gateway/gateway_device_state.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/register_refusal.h"
#include "kinds/interbus/words/device_number.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr int readsToAgree = 5;        // of OUT, when connecting (assumed)
constexpr int readsOfForeign = 3;      // before a word is somebody else's (assumed)
constexpr int refusalsOfReadBack = 3;  // until a gateway cannot read OUT back (assumed)
constexpr Instant betweenReads = 10ms; // while zeros are waited for

} // namespace

Result<void> GatewayLink::readOut(std::vector<Word> &words)
{
    for (const RegisterBlock &block : m_map->readBackBlocks()) {
        const auto registers = gateway::part(m_backRegisters, block, m_settings.outFirst);
        auto read = ask(gateway::readHolding, block,
                        [&] { return m_port->read(RegisterArea::holding, block.first, registers); });
        if (!read)
            return read;
    }
    words.resize(m_devices.size());
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        words[i] = m_map->word(gateway::part(m_backRegisters, m_map->out(i), m_settings.outFirst));
    return {};
}

// Two reads of each word that agree, so that no torn one is taken over. One that somebody else changes with
// every read stays as last read: it is noticed before the first write, if not before.
Result<void> GatewayLink::readOutUntilItAgrees(std::vector<Word> &words)
{
    std::vector<bool> agrees(m_devices.size());
    for (int reads = 0; reads < readsToAgree && std::ranges::find(agrees, false) != agrees.end(); ++reads) {
        std::vector<Word> read;
        if (reads > 0)
            m_port->wait(m_answeredAt + m_settings.copyTime);
        if (auto done = readOut(read); !done)
            return done;
        words.resize(read.size());
        for (std::size_t i = 0; i < read.size(); ++i) {
            const bool isAgreed = m_devices[i].out.take(read[i], m_answeredAt);
            if (isAgreed || !agrees[i])
                words[i] = read[i];
            agrees[i] = agrees[i] || isAgreed || m_map->out(i).count == 0;
        }
    }
    return {};
}

// One refusal of a gateway that has told OUT before is a failure like any other.
bool GatewayLink::cannotReadBack(const Refusal &why) const
{
    return !m_hasReadBack && isOfMap(why);
}

// After a reconnection: a gateway that shows OUT late would show what was there before the last words of
// ours, and that would be taken for the present state and sent again.
Result<void> GatewayLink::waitUntilOwnWordsShow()
{
    if (!m_lastWriteAt)
        return {};
    const Instant until = *m_lastWriteAt + OwnWord::gatewayLag;
    if (m_port->now() < until)
        m_port->wait(until);
    if (m_port->now() < until)
        return refuse(RefusalKind::stopped, RefusalId::cancelled);
    m_lastWriteAt.reset();
    return {};
}

// Then an OUT area that was refused is shorter than the ring, and must not be written as if nothing were
// there.
bool GatewayLink::canReadSomeOut()
{
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        const RegisterBlock &its = m_map->out(i);
        if (its.count == 0)
            continue;
        const auto registers = gateway::part(m_backRegisters, its, m_settings.outFirst);
        return ask(gateway::readHolding, its,
                   [&] { return m_port->read(RegisterArea::holding, its.first, registers); })
            .has_value();
    }
    return false;
}

Result<std::vector<Word>> GatewayLink::readBackOut()
{
    if (!m_map)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    const auto notRead = refuse(RefusalKind::notSupported, GatewayRefusalId::outNotReadBack);
    if (!m_readsBack)
        return notRead;
    if (auto shown = waitUntilOwnWordsShow(); !shown)
        return tl::unexpected(shown.error());
    std::vector<Word> words;
    auto read = readOutUntilItAgrees(words);
    for (int refusals = 1; !read && cannotReadBack(read.error()); ++refusals) {
        if (refusals == refusalsOfReadBack) {
            if (canReadSomeOut())
                return refuse(RefusalKind::link, GatewayRefusalId::outAreaTooShort,
                              {read.error().arguments[0], read.error().arguments[1]});
            m_readsBack = false;
            m_written.clear();
            return notRead;
        }
        read = readOutUntilItAgrees(words);
    }
    if (!read)
        return tl::unexpected(read.error());
    m_hasReadBack = true;
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        m_devices[i].own.found(words[i]);
    return words;
}

// Once: whoever asks for it sees what comes of it.
Result<void> GatewayLink::acknowledgeWatchdog()
{
    if (!m_map)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    if (!m_settings.watchdogRegister)
        return refuse(RefusalKind::notSupported, GatewayRefusalId::watchdogNotSet);
    const auto value = static_cast<Register>(m_settings.watchdogValue);
    const RegisterBlock its{*m_settings.watchdogRegister, 1};
    const auto done = transact([&] { return m_port->write(its.first, std::span(&value, 1)); }, false);
    return done
               ? Result<void>()
               : tl::unexpected(registerRefusal(done.error(), m_port->name(), gateway::writeHolding, its, 1));
}

void GatewayLink::claimOut(std::size_t device)
{
    if (!m_map || writesOut(device))
        return;
    m_devices[device].isClaimed = true;
    std::vector<bool> claimed;
    for (const Device &its : m_devices)
        claimed.push_back(its.isClaimed);
    m_written = m_map->outBlocksOf(claimed);
}

void GatewayLink::claimAll()
{
    for (Device &device : m_devices)
        device.isClaimed = true;
    m_written = m_map->outBlocks();
}

bool GatewayLink::writesOut(std::size_t device) const
{
    return m_readsBack || m_devices[device].isClaimed;
}

std::vector<std::size_t> GatewayLink::notOurs(const std::vector<Word> &there)
{
    std::vector<std::size_t> devices;
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        OwnWord &own = m_devices[i].own;
        if (!own.isKnown())
            own.found(there[i]); // nothing was written yet, and that may still be so after the first write
        if (m_map->out(i).count > 0 && !own.takes(there[i], m_port->now()))
            devices.push_back(i);
    }
    return devices;
}

// In Watch. One that was replaced just before is not taken over: what replaces it is on its way.
void GatewayLink::showOut(std::size_t device, Word there, Word &out)
{
    Device &its = m_devices[device];
    if (m_map->out(device).count == 0 || !its.out.take(there, m_answeredAt))
        return;
    const bool isOurs = its.own.isKnown() && its.own.takes(there, m_port->now());
    if (isOurs && !its.own.isShownBy(there))
        return;
    out = there;
    if (!isOurs)
        its.own.found(there);
}

std::uint64_t GatewayLink::reconnections() const
{
    const auto noticed = m_port->noticed();
    return m_connectedAgain + (noticed.closesAfterEach ? 0 : noticed.reconnections + noticed.closedAfterEach);
}

// Since OUT was last looked at. A gateway may have changed its outputs when it closed the connection.
bool GatewayLink::hasReconnected()
{
    const std::uint64_t now = reconnections();
    return std::exchange(m_reconnections, now) != now;
}

// What it has replaced does not count, unless it may not show yet.
bool GatewayLink::showsOwnWords(const std::vector<Word> &there) const
{
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        if (m_map->out(i).count > 0 && !m_devices[i].own.isShownBy(there[i]))
            return false;
    return true;
}

Result<void> GatewayLink::waitForOwnWords()
{
    std::vector<Word> there;
    for (;;) {
        if (auto read = readOut(there); !read)
            return read;
        if (showsOwnWords(there))
            return {};
        if (!m_lastWriteAt || m_port->now() >= *m_lastWriteAt + OwnWord::gatewayLag)
            break;
        m_port->wait(m_port->now() + betweenReads);
    }
    for (Device &device : m_devices)
        device.own.isThere();
    return {};
}

// Where OUT cannot be read back nobody knows what is there after a reconnection.
Result<void> GatewayLink::checkBlindWriting()
{
    if (m_readsBack || m_written.empty() || !hasReconnected())
        return {};
    return refuse(RefusalKind::link, RefusalId::connectionClosed, {m_port->name()});
}

// A connection may end while OUT is looked at.
Result<void> GatewayLink::checkIsOurs()
{
    Result<void> isOurs;
    do {
        if (hasReconnected())
            isOurs = waitForOwnWords();
        if (isOurs)
            isOurs = readWhetherOurs();
    } while (isOurs && reconnections() != m_reconnections);
    return isOurs;
}

// Somebody else's word shows in two reads that agree; so does a word that is another one in each read.
Result<void> GatewayLink::readWhetherOurs()
{
    std::vector<Word> there;
    std::vector<Word> before;
    std::vector<std::size_t> suspects;
    for (int reads = 0; reads < readsOfForeign; ++reads) {
        if (auto read = readOut(there); !read)
            return read;
        suspects = notOurs(there);
        if (suspects.empty())
            return {};
        if (!before.empty() && before[suspects.front()] == there[suspects.front()])
            break;
        before = there;
    }
    const std::size_t device = suspects.front();
    return refuse(
        RefusalKind::busy, GatewayRefusalId::outNotOurs,
        {DeviceNumber::of(m_ring[device].number).toString(), m_devices[device].own.word(), there[device]});
}

// Whether any word is another one than before.
bool GatewayLink::putOut(std::span<const Word> out)
{
    bool changes = false;
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        Device &device = m_devices[i];
        if (!writesOut(i))
            continue;
        m_map->put(out[i], gateway::part(m_outRegisters, m_map->out(i), m_settings.outFirst));
        changes = changes || !device.own.isKnown() || device.own.word() != out[i];
        device.own.write(out[i], m_port->now());
        device.out.forget();
    }
    return changes;
}

Result<void> GatewayLink::writeBlock(const RegisterBlock &block, Overwrites overwrites)
{
    const auto registers = gateway::part(m_outRegisters, block, m_settings.outFirst);
    return send(
               gateway::writeHolding, block, [&] { return m_port->write(block.first, registers); },
               overwrites)
        .map([](bool) {});
}

// Its IN words are from before the reaction to these OUT words: the function writes before it reads.
Result<void> GatewayLink::writeAndReadBlock(const RegisterBlock &block, const RegisterBlock &in,
                                            Overwrites overwrites)
{
    const auto from = gateway::part(m_outRegisters, block, m_settings.outFirst);
    const auto to = gateway::part(m_inRegisters, in, m_settings.inFirst);
    auto sent = send(
        gateway::writeAndReadHolding, block,
        [&] { return m_port->writeAndRead(block.first, from, in.first, to); }, overwrites);
    if (!sent)
        return tl::unexpected(sent.error());
    if (*sent) // otherwise the answer may be a late one
        takeBlock(in);
    return {};
}

// With function 23 IN is read along; what is read after a change of OUT may be the reaction to it already.
Result<void> GatewayLink::writeOut(std::span<const Word> out, Overwrites overwrites)
{
    const bool changes = putOut(out);
    auto written = writeBlocks(overwrites);
    if (!written || !m_settings.writesWithRead)
        return written;
    if (!changes)
        return readDoubtfulAgain();
    countDoubts();
    return {};
}

Result<void> GatewayLink::writeBlocks(Overwrites overwrites)
{
    const auto &ins = m_map->inBlocks();
    const std::size_t together = m_settings.writesWithRead ? ins.size() : 0;
    std::size_t k = 0;
    for (const RegisterBlock &block : m_written) {
        auto written =
            k < together ? writeAndReadBlock(block, ins[k], overwrites) : writeBlock(block, overwrites);
        if (!written)
            return writesLess(written.error(), block) ? writeBlocks(overwrites) : written;
        ++k;
    }
    for (; k < together; ++k) {
        if (auto read = readBlock(ins[k]); !read)
            return read;
        takeBlock(ins[k]);
    }
    return {};
}

// A gateway may take fewer registers in one request than Modbus allows, and says so by exception 3; no test
// can find that out without writing. The same words go out again, in smaller blocks.
bool GatewayLink::writesLess(const Refusal &why, const RegisterBlock &block)
{
    constexpr std::int64_t illegalValue = 3;
    const bool isTooMuch = why.id == GatewayRefusalId::registersRefused && why.arguments.size() > 2 &&
                           why.arguments[2] == RefusalArgument(illegalValue);
    const int less = block.count / 2 / GatewayMap::wordRegisters * GatewayMap::wordRegisters;
    if (!isTooMuch || m_settings.writesWithRead || less < GatewayMap::wordRegisters)
        return false;
    m_map->writeAtMost(less);
    std::vector<bool> written;
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        written.push_back(writesOut(i));
    m_written = m_map->outBlocksOf(written);
    return true;
}

// To all devices, whatever is there.
Result<void> GatewayLink::writeZeros()
{
    const auto writtenBefore = m_lastWriteAt;
    m_zeros.send(m_port->now());
    auto done = writeOut(std::vector<Word>(m_devices.size()), Overwrites::anything);
    if (done) {
        m_zeros.acknowledged(m_port->now());
    } else if (isNotCarriedOut(done.error())) {
        const ZerosByDevice all = writeZerosOneByOne(*m_map);
        noteZeros(all);
        if (all.areAllTaken())
            done = {};
    } else if (m_lastWriteAt == writtenBefore) {
        m_zeros.notSent();
    } else {
        m_zeros.unanswered();
    }
    return done;
}

// Each block once: a write needs no answer to be carried out, and a refusal is one.
bool GatewayLink::sendZerosUnheard()
{
    close();
    const auto map = GatewayMap::of(m_ring, m_settings);
    if (!map || !m_port->open())
        return false;
    m_counter.connected();
    m_zeros.send(m_port->now());
    ZerosByDevice all; // as if each block were one
    bool isRefused = false;
    for (const RegisterBlock &block : map->outBlocks()) {
        const auto done = writeZerosOnce(block);
        isRefused |= !done && isNotCarriedOut(done.error());
        all.take(done);
    }
    if (isRefused) {
        const ZerosByDevice each = writeZerosOneByOne(*map);
        all = {.isTaken = all.isTaken || each.isTaken,
               .isCut = all.isCut || each.isCut,
               .mayHaveArrived = all.mayHaveArrived || each.mayHaveArrived,
               .refusedBy = each.refusedBy};
    }
    noteZeros(all);
    m_port->close();
    return all.mayHaveArrived;
}

void GatewayLink::ZerosByDevice::take(const RegisterPort::Done &done)
{
    isTaken |= done.has_value();
    const bool isUnanswered = !done && !isNotCarriedOut(done.error());
    isCut |= isUnanswered;
    mayHaveArrived |= done || (isUnanswered && done.error().isSent);
}

// Of what is refused as a whole block each device gets its own: an OUT area may end too early, and a gateway
// may block some outputs only. None after one that is not answered.
GatewayLink::ZerosByDevice GatewayLink::writeZerosOneByOne(const GatewayMap &map)
{
    ZerosByDevice all;
    for (std::size_t i = 0; i < map.devices(); ++i) {
        if (map.out(i).count == 0)
            continue;
        const auto done = writeZerosOnce(map.out(i));
        all.take(done);
        if (all.isCut)
            break;
        if (!done)
            all.refusedBy.push_back(i);
    }
    return all;
}

RegisterPort::Done GatewayLink::writeZerosOnce(const RegisterBlock &block)
{
    const std::vector<Register> zeros(static_cast<std::size_t>(block.count));
    auto done = transact([&] { return m_port->write(block.first, zeros); }, false);
    if (m_map)
        noteSent(done, block);
    return done;
}

void GatewayLink::noteZeros(const ZerosByDevice &all)
{
    if (all.areAllTaken())
        m_zeros.acknowledged(m_port->now());
    else if (all.isCut && all.mayHaveArrived)
        m_zeros.unanswered();
    else if (all.isTaken)
        m_zeros.refusedBy(all.refusedBy);
    else if (!all.refusedBy.empty())
        m_zeros.refused();
    else
        m_zeros.notSent();
}

Result<ProcessDataLink::ZerosSent> GatewayLink::areZerosThere()
{
    const Instant end = m_port->now() + OwnWord::gatewayLag;
    for (;;) {
        std::vector<Word> there;
        if (auto read = readOut(there); !read)
            return tl::unexpected(read.error());
        if (std::ranges::all_of(there, [](Word word) { return word == 0; })) {
            m_zeros.readBack(m_port->now());
            for (std::size_t i = 0; i < there.size(); ++i)
                (void)m_devices[i].own.takes(there[i], m_port->now()); // what it replaced does not come back
            return ZerosSent{.areThere = true};
        }
        if (m_port->now() >= end)
            return ZerosSent{.areThere = false, .notZero = wordsNotZero(*this, m_ring, there)};
        m_port->wait(m_port->now() + betweenReads);
    }
}

} // namespace codewheel
