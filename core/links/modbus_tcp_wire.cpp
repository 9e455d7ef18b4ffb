// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/modbus_tcp_wire.h"

#include "encoder/sentence.h"
#include "links/wait_for.h"
#include "modbus/gateway_texts.h"

#include <array>
#include <cerrno>
#include <poll.h>
#include <sys/socket.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using modbus_message::Message;
using std::chrono::steady_clock;
using ErrorKind = RegisterError::Kind;
using Frame = std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH>;

// The header: transaction, protocol (0), length of what follows, unit. A function follows.
constexpr std::size_t lengthEnd = 6;
constexpr std::size_t unitAt = 6;
constexpr std::size_t headerLength = 7;
constexpr std::size_t shortest = headerLength + 1;
constexpr Instant shortestConnect = 2s; // a network may take longer than a unit
constexpr int longestMemory = 1'000;    // transactions

std::uint16_t numberAt(const Frame &frame, std::size_t at)
{
    return static_cast<std::uint16_t>(frame[at] << 8 | frame[at + 1]);
}

bool hasHungUp(int socket)
{
    pollfd waited{socket, POLLRDHUP, 0};
    return ::poll(&waited, 1, 0) > 0;
}

} // namespace

ModbusTcpWire::ModbusTcpWire(const GatewaySettings &settings, WakeFlag &wake)
    : m_settings(settings)
    , m_wake(wake)
{}

Result<void> ModbusTcpWire::open()
{
    close();
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
    m_modbus.reset();
    m_isOpen = false;
}

Result<void> ModbusTcpWire::connect(Instant timeOut)
{
    m_modbus.reset();
    auto socket = connectToHost(m_addresses, gatewayAddress(m_settings), timeOut, m_wake);
    if (!socket)
        return tl::unexpected(socket.error());
    Modbus modbus(modbus_new_tcp(nullptr, m_settings.tcpPort));
    if (!modbus)
        return refuse(RefusalKind::link, RefusalId::linkFailed,
                      {QString::fromLocal8Bit(modbus_strerror(errno))});
    modbus_set_socket(modbus.get(), socket->release());
    setAnswerTime(modbus.get(), 0us); // it is asked when the answer is there
    m_modbus = std::move(modbus);
    m_isOutOfStep = false;
    m_before = -1;
    m_wakesAt = 1;
    return {};
}

ModbusTcpWire::Failed ModbusTcpWire::failed(RegisterError error)
{
    if (error.kind == ErrorKind::closed)
        close();
    return tl::unexpected(std::move(error));
}

ModbusTcpWire::Failed ModbusTcpWire::outOfStep(const QString &text)
{
    m_isOutOfStep = true;
    return modbus_message::wrongAnswer(text);
}

tl::expected<Message, RegisterError> ModbusTcpWire::exchange(const Message &request)
{
    if (!m_isOpen)
        return failed(registerError(ErrorKind::closed));
    if (!m_modbus || m_isOutOfStep)
        if (auto connected = connect(m_settings.timeOut); !connected)
            return failed(registerError(connected.error().kind == RefusalKind::stopped ? ErrorKind::stopped
                                                                                       : ErrorKind::closed));
    const Time until = steady_clock::now() + m_settings.timeOut;
    if (auto sent = send(request); !sent)
        return tl::unexpected(sent.error());
    return receive(until);
}

// Not by the library: all raw requests that it sends have transaction 0, and its other calls wait for the
// answer without an end by anybody else, and do not look for which unit it is.
RegisterPort::Done ModbusTcpWire::send(const Message &request)
{
    ++m_transaction;
    m_before = std::min(m_before + 1, longestMemory);
    const std::size_t length = request.size() + 1; // with the unit
    Message frame{static_cast<std::uint8_t>(m_transaction >> 8),
                  static_cast<std::uint8_t>(m_transaction & 0xFF),
                  0,
                  0,
                  static_cast<std::uint8_t>(length >> 8),
                  static_cast<std::uint8_t>(length & 0xFF),
                  static_cast<std::uint8_t>(m_settings.unit)};
    frame.insert(frame.end(), request.begin(), request.end());
    const auto sent = ::send(modbus_get_socket(m_modbus.get()), frame.data(), frame.size(), MSG_NOSIGNAL);
    if (sent == static_cast<ssize_t>(frame.size()))
        return {};
    if (sent < 0 && errno != EAGAIN)
        return failed(closedError(errno));
    m_isOutOfStep = true; // whoever does not read does not answer either
    return failed(registerError(ErrorKind::noAnswer));
}

tl::expected<Message, RegisterError> ModbusTcpWire::receive(Time until)
{
    for (;;) {
        const auto length = waitForAnswer(until);
        if (!length)
            return failed(length.error());
        Frame frame{};
        const int received = modbus_receive_confirmation(m_modbus.get(), frame.data());
        if (received < 0) {
            m_isOutOfStep = true;
            return failed(answerError(errno));
        }
        if (static_cast<std::size_t>(received) != *length)
            return outOfStep(GatewayTexts::tr("its length does not fit its function"));
        if (isOver(numberAt(frame, 0)))
            continue;
        if (numberAt(frame, 0) != m_transaction)
            return outOfStep(sentence(GatewayTexts::tr("it is for transaction %1, not %2"),
                                      {QString::number(numberAt(frame, 0)), QString::number(m_transaction)}));
        if (frame[unitAt] != m_settings.unit)
            return outOfStep(
                sentence(GatewayTexts::tr("it is of unit %1"), {QString::number(frame[unitAt])}));
        return Message(frame.begin() + headerLength, frame.begin() + received);
    }
}

// A transaction before this one, of this connection.
bool ModbusTcpWire::isOver(std::uint16_t transaction) const
{
    const int before = static_cast<std::uint16_t>(m_transaction - transaction);
    return before > 0 && before <= m_before;
}

// Its length, as soon as all of it is there: the library, which then reads it, could not be interrupted.
tl::expected<std::size_t, RegisterError> ModbusTcpWire::waitForAnswer(Time until)
{
    std::size_t there = 0;
    wakeAt(1);
    for (;;) {
        const int socket = modbus_get_socket(m_modbus.get());
        const Waited waited = waitFor(socket, POLLIN, m_wake, until);
        if (waited == Waited::woken) {
            m_isOutOfStep = there > 0;
            return tl::unexpected(registerError(ErrorKind::stopped));
        }
        if (waited == Waited::timeOut) {
            m_isOutOfStep = there > 0;
            return tl::unexpected(there > 0 ? answerError(ETIMEDOUT) : registerError(ErrorKind::noAnswer));
        }
        Frame frame{};
        const auto seen = ::recv(socket, frame.data(), frame.size(), MSG_PEEK | MSG_DONTWAIT);
        if (seen < 0 && errno == EAGAIN)
            continue;
        if (seen <= 0)
            return tl::unexpected(closedError(seen < 0 ? errno : ECONNRESET));
        if (static_cast<std::size_t>(seen) < m_wakesAt && hasHungUp(socket)) // the rest will not come
            return tl::unexpected(closedError(ECONNRESET));
        there = static_cast<std::size_t>(seen);
        std::size_t length = shortest;
        if (there >= shortest) {
            length = lengthEnd + numberAt(frame, 4);
            if (numberAt(frame, 2) != 0 || length < shortest || length > frame.size())
                return outOfStep(GatewayTexts::tr("it is not Modbus"));
            if (there >= length)
                return length;
        }
        wakeAt(length);
    }
}

// From how many bytes on poll(2) takes the socket for readable.
void ModbusTcpWire::wakeAt(std::size_t bytes)
{
    if (bytes == m_wakesAt)
        return;
    m_wakesAt = bytes;
    const int count = static_cast<int>(bytes);
    ::setsockopt(modbus_get_socket(m_modbus.get()), SOL_SOCKET, SO_RCVLOWAT, &count, sizeof count);
}

} // namespace codewheel
