// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/links/modbus_tcp_wire.h"

#include "links/wait_for.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>
#include <utility>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using modbus_message::Pdu;
using std::chrono::steady_clock;
using ErrorKind = RegisterError::Kind;

// The header: transaction, protocol (0), length of what follows, unit. A function and its data follow.
constexpr std::size_t protocolAt = 2;
constexpr std::size_t lengthAt = 4;
constexpr std::size_t lengthEnd = 6;
constexpr std::size_t unitAt = 6;
constexpr std::size_t headerLength = 7;
constexpr std::size_t shortestAnswer = headerLength + 1;
constexpr std::size_t longestAnswer = 260; // MODBUS Messaging on TCP/IP, 3.1.3
constexpr std::size_t mostAtOnce = 4'096;
constexpr int mostDrained = 64;         // times as much that nobody asked for, before an exchange
constexpr unsigned triedEvery = 16;     // connections to a gateway that closes each
constexpr Instant shortestConnect = 2s; // a network may take longer than a unit
constexpr int longestMemory = 1'000;    // transactions
constexpr int fewAnswers = 16;          // on a connection (assumed)
constexpr int timesForHabit = 2;        // that a connection ended after few answers (assumed)
constexpr Instant leastIdle = 1s;       // until a gateway closes a connection as idle, at least (assumed)
constexpr int timesOfForeign = 2;       // that one number came, until it is always the same (assumed)
constexpr int timesOfOld = 3;           // the same of one that was ours: an answer may come twice (assumed)

RegisterError closedBy(int errorNumber)
{
    return {ErrorKind::closed, 0, QString::fromLocal8Bit(std::strerror(errorNumber))};
}

} // namespace

ModbusTcpWire::ModbusTcpWire(const GatewaySettings &settings)
    : m_settings(settings)
{}

Result<void> ModbusTcpWire::open()
{
    close();
    if (m_wake.lower())
        return refuse(RefusalKind::stopped, RefusalId::cancelled);
    auto addresses = resolveHost(m_settings.host, m_settings.tcpPort, m_wake);
    if (!addresses)
        return tl::unexpected(addresses.error());
    m_addresses = *std::move(addresses);
    auto connected = connect(std::max(m_settings.timeOut, shortestConnect));
    m_isOpen = connected.has_value();
    return connected;
}

void ModbusTcpWire::close()
{
    m_socket.close();
    m_isOpen = false;
}

Result<void> ModbusTcpWire::connect(Instant timeOut)
{
    m_socket.close();
    auto socket = connectToHost(m_addresses, gatewayAddress(m_settings), timeOut, m_wake);
    if (!socket)
        return tl::unexpected(socket.error());
    m_socket = *std::move(socket);
    m_received.clear();
    m_isOutOfStep = false;
    m_before = -1;
    m_answers = 0;
    m_connectedAt = steady_clock::now();
    return {};
}

ModbusTcpWire::Failed ModbusTcpWire::failed(RegisterError error)
{
    if (error.kind == ErrorKind::closed) {
        error.isAtOnce = error.isAtOnce || m_answers == 0;
        close();
    }
    return tl::unexpected(std::move(error));
}

ModbusTcpWire::Failed ModbusTcpWire::outOfStep(WrongAnswer what, std::initializer_list<int> numbers)
{
    m_isOutOfStep = true;
    return modbus_message::wrongAnswer(what, numbers);
}

tl::expected<Pdu, RegisterError> ModbusTcpWire::exchange(const Pdu &request)
{
    if (m_wake.lower())
        return failed({.kind = ErrorKind::stopped});
    if (!m_isOpen)
        return failed({.kind = ErrorKind::closed});
    const bool writes = modbus_message::writes(request);
    const bool isOver = isGivenUp();
    const bool isAnew = isOver || (m_closesAfterEach && m_answers > 0 && !keepsAgain(writes));
    if (isOver && !m_closesAfterEach && writes)
        return failed({.kind = ErrorKind::closed, .isSent = false});
    if (!m_socket || m_isOutOfStep || isAnew) {
        if (auto connected = connectAnew(); !connected)
            return failed(connected.error());
        if (isAnew)
            countClosing();
    }
    auto answer = ask(request);
    const bool isCrossed = !answer && answer.error().kind == ErrorKind::closed && m_answers > 0;
    if (!isCrossed || writes)
        return answer;
    m_isOpen = true;
    if (auto connected = connectAnew(); !connected)
        return failed(connected.error());
    countClosing();
    return ask(request);
}

RegisterPort::Done ModbusTcpWire::connectAnew()
{
    const auto connected = connect(m_settings.timeOut);
    if (connected) {
        ++m_renewals;
        return {};
    }
    const bool isStopped = connected.error().kind == RefusalKind::stopped;
    return tl::unexpected(RegisterError{.kind = isStopped ? ErrorKind::stopped : ErrorKind::closed,
                                        .isAtOnce = connected.error().id == RefusalId::connectionRefused});
}

tl::expected<Pdu, RegisterError> ModbusTcpWire::ask(const Pdu &request)
{
    const Time until = steady_clock::now() + m_settings.timeOut;
    if (auto sent = send(request); !sent)
        return tl::unexpected(sent.error());
    return receive(until);
}

// Nothing is on its way then, so that nothing is in doubt.
bool ModbusTcpWire::isGivenUp()
{
    std::array<std::uint8_t, mostAtOnce> late{};
    ssize_t came = 1;
    for (int reads = 0; m_socket && came > 0; ++reads) {
        came = ::recv(m_socket.get(), late.data(), late.size(), MSG_DONTWAIT);
        if (came > 0 && reads == mostDrained) { // it does not stop sending
            m_isOutOfStep = true;
            return false;
        }
    }
    const bool isClosed = m_socket && (came == 0 || (errno != EAGAIN && errno != EINTR));
    if (isClosed)
        learnFromClosing(false);
    return isClosed;
}

// The connection is still there: now and then a read tries whether the gateway keeps it again.
bool ModbusTcpWire::keepsAgain(bool writes)
{
    if (m_answers > 1)
        m_closesAfterEach = false;
    return !m_closesAfterEach || (!writes && ++m_untried % triedEvery == 0);
}

void ModbusTcpWire::learnFromClosing(bool crossesRequest)
{
    if (m_answers > fewAnswers)
        m_shortConnections = 0;
    else if (crossesRequest && m_answers > 0)
        ++m_shortConnections;
    m_closesAfterEach = m_closesAfterEach || m_answers == 1 || m_shortConnections >= timesForHabit;
    const bool isSoon = m_answers > 0 && steady_clock::now() - m_answeredAt < leastIdle;
    m_closedSoon = isSoon && !isKept() ? m_closedSoon + 1 : 0;
    m_keepsNone = m_keepsNone || m_closesAfterEach || m_closedSoon >= timesForHabit;
}

bool ModbusTcpWire::isKept() const
{
    return m_answers > fewAnswers && m_answeredAt - m_connectedAt >= leastIdle;
}

// One that is left before the gateway closes it counts as closed.
void ModbusTcpWire::countClosing()
{
    ++(m_keepsNone ? m_closedAfterEach : m_reconnections);
}

void ModbusTcpWire::countAnswer()
{
    ++m_answers;
    m_answeredAt = steady_clock::now();
    if (isKept())
        m_keepsNone = false;
}

RegisterPort::Done ModbusTcpWire::send(const Pdu &request)
{
    ++m_transaction;
    m_before = std::min(m_before + 1, longestMemory);
    const std::size_t length = request.size() + 1; // with the unit
    Pdu frame{static_cast<std::uint8_t>(m_transaction >> 8),
              static_cast<std::uint8_t>(m_transaction & 0xFF),
              0,
              0,
              static_cast<std::uint8_t>(length >> 8),
              static_cast<std::uint8_t>(length & 0xFF),
              static_cast<std::uint8_t>(m_settings.unit)};
    frame.insert(frame.end(), request.begin(), request.end());
    const auto sent = ::send(m_socket.get(), frame.data(), frame.size(), MSG_NOSIGNAL);
    if (sent == static_cast<ssize_t>(frame.size()))
        return {};
    if (sent < 0 && errno != EAGAIN)
        return failed(closedBy(errno));
    m_isOutOfStep = true; // whoever does not read does not answer either
    return failed({.kind = ErrorKind::noAnswer});
}

// However much comes: what has not answered by then does not count.
tl::expected<Pdu, RegisterError> ModbusTcpWire::receive(Time until)
{
    for (;;) {
        auto next = nextAnswer();
        if (!next)
            return failed(next.error());
        if (!*next) {
            if (auto more = receiveMore(until); !more)
                return failed(more.error());
            continue;
        }
        Answer &answer = **next;
        const int times = timesInARow(answer.transaction);
        if (isOver(answer.transaction) && times < timesOfOld) {
            m_comesLate = true;
            continue;
        }
        if (answer.transaction != m_transaction)
            return ofForeignTransaction(answer.transaction);
        if (answer.unit != m_settings.unit)
            return outOfStep(WrongAnswer::unit, {answer.unit});
        countAnswer();
        m_comesLate = false;
        return std::move(answer.pdu);
    }
}

int ModbusTcpWire::timesInARow(std::uint16_t transaction)
{
    if (m_oneNumber.times == 0 || m_oneNumber.transaction != transaction)
        m_oneNumber = {transaction, m_transaction, 1};
    else if (std::exchange(m_oneNumber.request, m_transaction) != m_transaction)
        ++m_oneNumber.times;
    return m_oneNumber.times;
}

// A gateway that always sends the same number cannot be used: nothing tells its late answers.
ModbusTcpWire::Failed ModbusTcpWire::ofForeignTransaction(std::uint16_t transaction)
{
    if (m_oneNumber.times >= timesOfForeign)
        return outOfStep(WrongAnswer::oneTransaction, {transaction});
    return outOfStep(WrongAnswer::transaction, {transaction, m_transaction});
}

// The one that has come completely; empty: none has.
tl::expected<std::optional<ModbusTcpWire::Answer>, RegisterError> ModbusTcpWire::nextAnswer()
{
    if (m_received.size() < shortestAnswer)
        return std::optional<Answer>();
    const std::size_t length = lengthEnd + registerAt(m_received, lengthAt);
    if (registerAt(m_received, protocolAt) != 0 || length < shortestAnswer || length > longestAnswer)
        return outOfStep(WrongAnswer::notModbus);
    if (m_received.size() < length)
        return std::optional<Answer>();
    const auto end = m_received.begin() + static_cast<std::ptrdiff_t>(length);
    Answer answer{registerAt(m_received, 0), m_received[unitAt], {m_received.begin() + headerLength, end}};
    m_received.erase(m_received.begin(), end);
    return answer;
}

RegisterPort::Done ModbusTcpWire::receiveMore(Time until)
{
    const Waited waited =
        steady_clock::now() < until ? waitFor(m_socket.get(), POLLIN, m_wake, until) : Waited::timeOut;
    if (waited == Waited::woken)
        return tl::unexpected(RegisterError{.kind = ErrorKind::stopped});
    if (waited == Waited::timeOut && !m_received.empty())
        return outOfStep(WrongAnswer::incomplete);
    if (waited == Waited::timeOut)
        return tl::unexpected(RegisterError{.kind = ErrorKind::noAnswer, .isLate = m_comesLate});
    std::array<std::uint8_t, mostAtOnce> bytes{};
    const auto came = ::recv(m_socket.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (came < 0 && errno == EAGAIN)
        return {};
    if (came <= 0) {
        const int why = came < 0 ? errno : ECONNRESET;
        learnFromClosing(true);
        return tl::unexpected(closedBy(why));
    }
    m_received.insert(m_received.end(), bytes.begin(), bytes.begin() + came);
    return {};
}

// A transaction before this one, of this connection.
bool ModbusTcpWire::isOver(std::uint16_t transaction) const
{
    const int before = static_cast<std::uint16_t>(m_transaction - transaction);
    return before > 0 && before <= m_before;
}

Instant ModbusTcpWire::now() const
{
    return std::chrono::duration_cast<Instant>(steady_clock::now() - m_begin);
}

void ModbusTcpWire::wait(Instant until)
{
    waitFor(-1, 0, m_wake, m_begin + until);
}

} // namespace codewheel
