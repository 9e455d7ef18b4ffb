// SPDX-License-Identifier: GPL-3.0-or-later
// The transactions of a gateway, and IN.
#include "jobs/value_notes.h"
#include "jobs/values_to_write.h"
#include "kinds/interbus/gateway/gateway_check_text.h"
#include "kinds/interbus/gateway/gateway_device_state.h"
#include "kinds/interbus/gateway/register_refusal.h"
#include "vocabulary/encoder_session.h"

namespace codewheel {
namespace {

constexpr int readsInDoubt = 2;  // more in one exchange, while words are not believed (assumed)
constexpr int readsOfSeldom = 5; // the same, where it is polled seldom: each exchange has to do (assumed)
constexpr Instant seldom = std::chrono::milliseconds(250);
// Between two looks at the status register: where it decides what is shown, and where it is only shown.
constexpr Instant betweenDecisions = std::chrono::milliseconds(100);
constexpr Instant betweenStatus = std::chrono::milliseconds(500);

} // namespace

RegisterPort::Done GatewayLink::transact(const std::function<RegisterPort::Done()> &call, bool again)
{
    const Instant begun = m_port->now();
    RegisterPort::Done done = call();
    const Instant ended = m_port->now();
    m_answeredAt = begun + (ended - begun) / 2;
    m_answerTook = ended - begun;
    m_counter.transaction(done, begun, ended, again);
    return done;
}

RegisterPort::Done GatewayLink::readOnce(const std::function<RegisterPort::Done()> &call, bool again)
{
    if (m_hurriesToZeros)
        return tl::unexpected(RegisterError{RegisterError::Kind::stopped, 0, {}});
    return transact(call, again);
}

// A gateway may close a connection just as it is asked: nothing was lost then but a read.
bool GatewayLink::connectsAgain(RegisterTries &tries)
{
    if (!tries.mayFailAgain() || !m_port->open())
        return false;
    tries.wasSent();
    m_connectedAgain += m_port->noticed().closesAfterEach ? 0 : 1;
    m_counter.connected();
    return true;
}

// A read. The first answer after one that was missing may be that one, come late, which a serial line cannot
// tell: the next one counts.
Result<void> GatewayLink::ask(int function, const RegisterBlock &block,
                              const std::function<RegisterPort::Done()> &call)
{
    RegisterTries tries(*m_port, m_settings);
    bool mayBeLate = false;
    for (;;) {
        RegisterPort::Done done = readOnce(call, tries.sent() > 0);
        if (done && !mayBeLate)
            return {};
        mayBeLate = !done && !isBusy(done.error());
        const bool isClosed = !done && done.error().kind == RegisterError::Kind::closed;
        if (isClosed && !m_isWriting && connectsAgain(tries))
            mayBeLate = false;
        else if (!done && !tries.goOn(done))
            return tl::unexpected(
                registerRefusal(done.error(), m_port->name(), function, block, tries.sent()));
    }
}

// The same words twice act once only if OUT has not changed in between, and a gateway may change it when it
// closes a connection: not if it closes each.
bool GatewayLink::mayFollowClosing(const RegisterError &error) const
{
    const bool isHarmless = !error.isSent || m_port->noticed().closesAfterEach;
    return error.kind == RegisterError::Kind::closed && m_readsBack && isHarmless;
}

// A write, which may have been carried out although its answer is missing, and somebody else may have written
// since: OUT is read back before it is sent again. Whether the first one was answered. With outNotOurs
// nothing of this exchange has been sent.
Result<bool> GatewayLink::send(int function, const RegisterBlock &block,
                               const std::function<RegisterPort::Done()> &call, Overwrites overwrites)
{
    for (RegisterTries tries(*m_port, m_settings);;) {
        RegisterPort::Done done = transact(call, tries.sent() > 0);
        noteSent(done, block);
        if (done)
            return tries.failures() == 0;
        const auto failed = [&] {
            return tl::unexpected(
                registerRefusal(done.error(), m_port->name(), function, block, tries.sent()));
        };
        const bool isKept = mayFollowClosing(done.error()) && connectsAgain(tries);
        if (!isKept && !tries.goOn(done))
            return failed();
        if (!m_readsBack || overwrites == Overwrites::anything)
            continue;
        if (auto ours = checkIsOurs(); !ours)
            return m_mayBeSent ? failed() : tl::unexpected(ours.error());
    }
}

void GatewayLink::noteSent(const RegisterPort::Done &done, const RegisterBlock &block)
{
    const bool mayArrive = done || (done.error().isSent && !isNotCarriedOut(done.error()));
    if (done || done.error().isSent)
        m_lastWriteAt = m_port->now();
    m_mayBeSent = m_mayBeSent || mayArrive;
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        OwnWord &own = m_devices[i].own;
        if (!gateway::holds(block, m_map->out(i)))
            continue;
        if (done)
            own.wasAnswered(m_port->now());
        else if (mayArrive)
            own.wasNotAnswered();
        else
            own.wasNotSent();
    }
}

Result<void> GatewayLink::readBlock(const RegisterBlock &block)
{
    const auto registers = gateway::part(m_inRegisters, block, m_settings.inFirst);
    return ask(readFunction(m_settings.inArea), block,
               [&] { return m_port->read(m_settings.inArea, block.first, registers); });
}

void GatewayLink::takeBlock(const RegisterBlock &block)
{
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        const RegisterBlock &its = m_map->in(i);
        if (!gateway::holds(block, its))
            continue;
        const Word read = m_map->word(gateway::part(m_inRegisters, its, m_settings.inFirst));
        m_devices[i].believed |= m_devices[i].in.take(read, m_answeredAt, m_answerTook);
    }
}

void GatewayLink::beginToRead()
{
    for (Device &device : m_devices)
        device.believed = false;
}

Result<void> GatewayLink::readIn()
{
    for (const RegisterBlock &block : m_map->inBlocks()) {
        if (auto read = readBlock(block); !read)
            return read;
        takeBlock(block);
    }
    return {};
}

bool GatewayLink::isDoubtful(std::size_t device) const
{
    return m_map && m_map->in(device).count > 0 && !m_devices[device].believed;
}

bool GatewayLink::needsAnotherRead(std::size_t device) const
{
    const bool isNextReadSoon = m_settings.pollInterval < WordGate::shortWait;
    return isDoubtful(device) && !(isNextReadSoon && m_devices[device].in.canWait());
}

bool GatewayLink::hasDoubtful(const RegisterBlock &block) const
{
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        if (needsAnotherRead(i) && gateway::holds(block, m_map->in(i)))
            return true;
    return false;
}

// Reads of three exchanges are so far apart that a shaft has often gone too far between them.
bool GatewayLink::pollsSeldom() const
{
    return m_settings.pollInterval >= seldom;
}

bool GatewayLink::needsTime(const RegisterBlock &block) const
{
    if (pollsSeldom())
        return true;
    const bool isNextReadFar = m_settings.pollInterval > m_settings.copyTime;
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        if (needsAnotherRead(i) && gateway::holds(block, m_map->in(i)) &&
            m_devices[i].in.needsTime(isNextReadFar))
            return true;
    return false;
}

// Whole blocks: their length is what tells late answers apart.
Result<void> GatewayLink::readDoubtfulAgain()
{
    for (int again = 0; again < (pollsSeldom() ? readsOfSeldom : readsInDoubt); ++again)
        for (const RegisterBlock &block : m_map->inBlocks()) {
            if (!hasDoubtful(block))
                continue;
            if (needsTime(block))
                m_port->wait(m_answeredAt + m_settings.copyTime);
            if (auto read = readBlock(block); !read)
                return read;
            takeBlock(block);
        }
    countDoubts();
    return {};
}

void GatewayLink::countDoubts()
{
    std::size_t torn = 0;
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        const bool isInDoubt = needsAnotherRead(i);
        m_devices[i].doubts = isInDoubt ? m_devices[i].doubts + 1 : 0;
        torn += isInDoubt ? 1 : 0;
    }
    m_counter.torn(torn);
}

void GatewayLink::showIn(std::span<Word> in)
{
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        in[i] = m_devices[i].in.word();
}

// As the registers would be judged by a test of the gateway.
std::optional<DataCheck> GatewayLink::checkWord(std::size_t device, Word in,
                                                const EncoderSession &encoder) const
{
    const auto map = GatewayMap::of(m_ring, m_settings);
    if (!map || device >= map->devices())
        return std::nullopt;
    DeviceRegisters shown{.place = m_ring[device].number, .in = map->in(device), .out = map->out(device)};
    shown.inNow.resize(static_cast<std::size_t>(shown.in.count));
    map->put(in, shown.inNow);
    shown.readings = wordReadings(shown.inNow, senderOf(encoder.device(), valuesOf(allKnown(encoder))));
    return wordCheck(shown, m_settings);
}

Result<Register> GatewayLink::readRegister(int first)
{
    Register word = 0;
    const RegisterBlock block{first, 1};
    return ask(readFunction(m_settings.inArea), block,
               [&] { return m_port->read(m_settings.inArea, first, std::span(&word, 1)); })
        .map([&] { return word; });
}

Result<void> GatewayLink::readStatus()
{
    if (!m_settings.statusRegister || m_port->now() < m_nextStatus)
        return {};
    const auto status = readRegister(*m_settings.statusRegister);
    if (!status)
        return tl::unexpected(status.error());
    m_counter.status(*status);
    m_nextStatus = m_port->now() + (m_settings.tellsRing() ? betweenDecisions : betweenStatus);
    auto told = codewheel::toldRing(m_settings, *status);
    if (told && told->hasFailed && m_settings.placeRegister) {
        const auto place = readRegister(*m_settings.placeRegister);
        if (!place)
            return tl::unexpected(place.error());
        told->place = *place;
    }
    m_told = told;
    return {};
}

} // namespace codewheel
