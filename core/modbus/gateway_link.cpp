// SPDX-License-Identifier: GPL-3.0-or-later
#include "modbus/gateway_link.h"

#include "modbus/register_refusal.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr int readsInDoubt = 2;           // more in one exchange, while words are not believed
constexpr int exchangesInDoubt = 8;       // after that the word is not up to date any more
constexpr Instant gatewayLag = 1s;        // until a word that was written must be read back (assumed)
constexpr Instant betweenStatus = 500ms;  // between two looks at the status register
tl::unexpected<Refusal> notConnectedYet()
{
    return refuse(RefusalKind::link, RefusalId::lineClosed);
}

std::span<Register> part(std::vector<Register> &image, const RegisterBlock &block, int first)
{
    return std::span(image).subspan(static_cast<std::size_t>(block.first - first),
                                    static_cast<std::size_t>(block.count));
}

int endOf(const std::vector<RegisterBlock> &blocks, int first)
{
    return blocks.empty() ? first : blocks.back().end();
}

} // namespace

struct GatewayLink::Device
{
    WordGate in;
    WordGate out; // in Watch: what somebody else writes may be torn too
    bool believed = false;
    int doubts = 0; // exchanges in a row without a word that could be believed
    // What OUT is on the gateway as far as we know, what it was before, and since when.
    std::optional<Word> ours{};
    Word before = 0;
    Instant since{};
};

GatewayLink::GatewayLink(std::unique_ptr<RegisterPort> port, GatewaySettings settings,
                         const std::vector<GatewayDevice> &ring)
    : m_port(std::move(port))
    , m_settings(std::move(settings))
{
    for (const GatewayDevice &device : ring) {
        m_ring.push_back(device.participant);
        m_devices.push_back({WordGate(device.profile, device.participant.inWords),
                             WordGate(std::nullopt, device.participant.outWords)});
    }
}

GatewayLink::~GatewayLink() = default;

// Sends a request until there is a valid answer, or one that another try would not change.
template <class Call>
Result<void> GatewayLink::transact(int function, const RegisterBlock &block, Call call)
{
    for (int tries = 1;; ++tries) {
        const Instant begun = m_port->now();
        const RegisterPort::Done done = call();
        m_counter.transaction(done, begun, m_port->now(), tries > 1);
        if (done)
            return {};
        if (!isWorthRepeating(done.error()) || tries > m_settings.retries)
            return tl::unexpected(registerRefusal(done.error(), m_port->name(), function, block, tries));
    }
}

Result<RingStructure> GatewayLink::open()
{
    close();
    if (m_ring.empty())
        return refuse(RefusalKind::badInput, RefusalId::gatewayHasNoDevices);
    auto map = GatewayMap::of(m_ring, m_settings);
    if (!map)
        return tl::unexpected(map.error());
    if (auto opened = m_port->open(); !opened)
        return tl::unexpected(opened.error());
    m_counter.connected();
    m_map = *std::move(map);
    m_readsBack = m_settings.readsBack;
    m_inRegisters.assign(
        static_cast<std::size_t>(endOf(m_map->inBlocks(), m_settings.inFirst) - m_settings.inFirst), 0);
    m_outRegisters.assign(
        static_cast<std::size_t>(endOf(m_map->outBlocks(), m_settings.outFirst) - m_settings.outFirst), 0);
    if (auto read = readIn(); !read) {
        close();
        return tl::unexpected(read.error());
    }
    return m_ring;
}

void GatewayLink::close()
{
    m_port->close();
    m_map.reset();
    for (Device &device : m_devices) {
        device.in.forget();
        device.out.forget();
        device.ours.reset();
        device.doubts = 0;
    }
}

Result<void> GatewayLink::checkUse(std::size_t outWords, std::size_t inWords) const
{
    if (!m_map || outWords != m_devices.size() || inWords != m_devices.size())
        return notConnectedYet();
    return {};
}

Result<void> GatewayLink::readBlock(const RegisterBlock &block)
{
    const auto registers = part(m_inRegisters, block, m_settings.inFirst);
    return transact(readFunction(m_settings.inArea), block,
                    [&] { return m_port->read(m_settings.inArea, block.first, registers); });
}

void GatewayLink::takeBlock(const RegisterBlock &block)
{
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        const RegisterBlock &its = m_map->in(i);
        if (its.count == 0 || its.first < block.first || its.end() > block.end())
            continue;
        const Word read = m_map->word(part(m_inRegisters, its, m_settings.inFirst));
        m_devices[i].believed |= m_devices[i].in.take(read);
    }
}

Result<void> GatewayLink::readIn()
{
    for (Device &device : m_devices)
        device.believed = false;
    for (const RegisterBlock &block : m_map->inBlocks()) {
        if (auto read = readBlock(block); !read)
            return read;
        takeBlock(block);
    }
    return {};
}

bool GatewayLink::isDoubtful(std::size_t device) const
{
    return m_map->in(device).count > 0 && !m_devices[device].believed;
}

// Whole blocks: their length is what tells late answers apart.
Result<void> GatewayLink::readDoubtfulAgain()
{
    for (int again = 0; again < readsInDoubt; ++again)
        for (const RegisterBlock &block : m_map->inBlocks()) {
            bool isInDoubt = false;
            for (std::size_t i = 0; i < m_devices.size(); ++i)
                isInDoubt |=
                    isDoubtful(i) && m_map->in(i).first >= block.first && m_map->in(i).end() <= block.end();
            if (!isInDoubt)
                continue;
            if (auto read = readBlock(block); !read)
                return read;
            takeBlock(block);
        }
    std::size_t torn = 0;
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        m_devices[i].doubts = isDoubtful(i) ? m_devices[i].doubts + 1 : 0;
        torn += isDoubtful(i) ? 1 : 0;
    }
    m_counter.torn(torn);
    return {};
}

Result<void> GatewayLink::readOut(std::vector<Word> &words)
{
    for (const RegisterBlock &block : m_map->readBackBlocks()) {
        const auto registers = part(m_outRegisters, block, m_settings.outFirst);
        auto read = transact(readFunction(RegisterArea::holding), block,
                             [&] { return m_port->read(RegisterArea::holding, block.first, registers); });
        if (!read)
            return read;
    }
    words.resize(m_devices.size());
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        words[i] = m_map->word(part(m_outRegisters, m_map->out(i), m_settings.outFirst));
    return {};
}

// Two reads that agree, so that no torn word is taken over. A gateway may not let them be read at all.
Result<std::vector<Word>> GatewayLink::readBackOut()
{
    if (!m_map)
        return notConnectedYet();
    const auto notRead = refuse(RefusalKind::notSupported, RefusalId::outNotReadBack);
    if (!m_readsBack)
        return notRead;
    std::vector<Word> words;
    std::vector<Word> again;
    auto read = readOut(words);
    for (int tries = 0; read && tries <= m_settings.retries && again != words; ++tries) {
        again = words;
        read = readOut(words);
    }
    if (!read && isOfMap(read.error())) {
        m_readsBack = false;
        return notRead;
    }
    if (!read)
        return tl::unexpected(read.error());
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        m_devices[i].ours = words[i];
        m_devices[i].before = words[i];
    }
    return words;
}

// Somebody else's word shows in two reads that agree; one that is not there yet is no such word.
Result<void> GatewayLink::checkIsOurs()
{
    std::vector<Word> there;
    std::vector<Word> again;
    if (auto read = readOut(there); !read)
        return read;
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        Device &device = m_devices[i];
        const bool isLate = there[i] == device.before && m_port->now() - device.since < gatewayLag;
        if (m_map->out(i).count == 0 || !device.ours || there[i] == *device.ours || isLate)
            continue;
        if (again.empty())
            if (auto read = readOut(again); !read)
                return read;
        if (again[i] == *device.ours || again[i] != there[i])
            continue;
        const Word ours = *std::exchange(device.ours, there[i]);
        return refuse(RefusalKind::busy, RefusalId::outNotOurs,
                      {DeviceNumber::of(m_ring[i].number).toString(), ours, there[i]});
    }
    return {};
}

Result<void> GatewayLink::writeOut(std::span<const Word> out)
{
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        Device &device = m_devices[i];
        m_map->put(out[i], part(m_outRegisters, m_map->out(i), m_settings.outFirst));
        if (device.ours == out[i])
            continue;
        device.before = device.ours.value_or(out[i]);
        device.ours = out[i];
        device.since = m_port->now();
    }
    const auto &ins = m_map->inBlocks();
    std::size_t k = 0;
    for (const RegisterBlock &block : m_map->outBlocks()) {
        const auto registers = part(m_outRegisters, block, m_settings.outFirst);
        const bool reads = m_settings.writesWithRead && k < ins.size();
        auto written =
            reads ? transact(23, block,
                             [&] {
                                 return m_port->writeAndRead(block.first, registers, ins[k].first,
                                                             part(m_inRegisters, ins[k], m_settings.inFirst));
                             })
                  : transact(16, block, [&] { return m_port->write(block.first, registers); });
        if (!written)
            return written;
        if (reads)
            takeBlock(ins[k++]);
    }
    for (; m_settings.writesWithRead && k < ins.size(); ++k) {
        if (auto read = readBlock(ins[k]); !read)
            return read;
        takeBlock(ins[k]);
    }
    return {};
}

Result<void> GatewayLink::exchangeWords(std::span<const Word> out, std::span<Word> in)
{
    for (Device &device : m_devices)
        device.believed = false;
    if (auto written = writeOut(out); !written)
        return written;
    if (!m_settings.writesWithRead)
        if (auto read = readIn(); !read)
            return read;
    if (auto read = readDoubtfulAgain(); !read)
        return read;
    showIn(in);
    return readStatus();
}

void GatewayLink::showIn(std::span<Word> in)
{
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        in[i] = m_devices[i].in.word();
}

Result<void> GatewayLink::readStatus()
{
    if (!m_settings.statusRegister || m_port->now() < m_nextStatus)
        return {};
    m_nextStatus = m_port->now() + betweenStatus;
    Register status = 0;
    const RegisterBlock block{*m_settings.statusRegister, 1};
    auto read = transact(readFunction(m_settings.inArea), block,
                         [&] { return m_port->read(m_settings.inArea, block.first, std::span(&status, 1)); });
    if (read)
        m_counter.status(status);
    return read;
}

// An exchange is what elsewhere is a bus cycle: with the time the ring takes to react.
void GatewayLink::settle(Instant begun)
{
    m_counter.exchanged(m_port->now());
    m_nextExchange = std::max(begun + m_settings.pollInterval, m_port->now() + m_settings.reactionDelay);
}

Result<void> GatewayLink::exchange(std::span<const Word> out, std::span<Word> in)
{
    if (auto usable = checkUse(out.size(), in.size()); !usable)
        return usable;
    const Instant begun = m_port->now();
    if (m_readsBack)
        if (auto ours = checkIsOurs(); !ours)
            return ours;
    auto done = exchangeWords(out, in);
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
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            Device &device = m_devices[i];
            if (m_map->out(i).count == 0 || !device.out.take(there[i]))
                continue;
            out[i] = there[i];
            device.ours = there[i];
            device.before = there[i];
        }
    }
    if (auto read = readIn(); !read)
        return read;
    if (auto read = readDoubtfulAgain(); !read)
        return read;
    showIn(in);
    auto done = readStatus();
    settle(begun);
    return done;
}

Result<std::optional<bool>> GatewayLink::sendZeros(std::span<Word> in)
{
    if (auto usable = checkUse(in.size(), in.size()); !usable)
        return tl::unexpected(usable.error());
    const Instant begun = m_port->now();
    const std::vector<Word> zeros(in.size());
    if (auto sent = exchangeWords(zeros, in); !sent)
        return tl::unexpected(sent.error());
    settle(begun);
    if (!m_readsBack)
        return std::optional<bool>();
    std::vector<Word> there;
    for (int tries = 0; tries <= m_settings.retries; ++tries) {
        if (auto read = readOut(there); !read)
            return tl::unexpected(read.error());
        if (there == zeros)
            return std::optional(true);
    }
    return std::optional(false);
}

bool GatewayLink::isUpToDate(std::size_t device) const
{
    const Device &its = m_devices[device];
    return !m_map || m_map->in(device).count == 0 || (its.in.hasWord() && its.doubts < exchangesInDoubt);
}

void GatewayLink::wait(Instant until)
{
    m_port->wait(m_map ? m_nextExchange : until);
}

} // namespace codewheel
