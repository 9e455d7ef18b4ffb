// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/modbus_rtu_wire.h"

#include "encoder/sentence.h"
#include "links/line_rate.h"
#include "links/low_latency.h"
#include "links/port_access.h"
#include "links/wait_for.h"
#include "modbus/gateway_texts.h"

#include <QFile>

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/select.h>
#include <termios.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using modbus_message::Message;
using std::chrono::steady_clock;
using ErrorKind = RegisterError::Kind;

constexpr int gapCharacters = 4;     // 3.5, MODBUS over Serial Line, 2.5.1.1
constexpr Instant shortestGap = 2ms; // 1.75 ms, there
constexpr int longestQuietWait = 5;  // times the time-out
constexpr int frameOverhead = 3;     // unit and checksum

Refusal systemRefusal(int errorNumber, const QString &path)
{
    return portRefusal(portRefusalOf(errorNumber), path,
                       QString::fromLocal8Bit(modbus_strerror(errorNumber)));
}

char parityLetter(SerialSettings::Parity parity)
{
    return std::array{'N', 'E', 'O'}.at(static_cast<std::size_t>(parity));
}

// A unit that always answers twice is one to live with.
bool isSame(const Message &answer, const tl::expected<Message, RegisterError> &second)
{
    return second && *second == answer;
}

} // namespace

ModbusRtuWire::ModbusRtuWire(const GatewaySettings &settings, WakeFlag &wake)
    : m_settings(settings)
    , m_wake(wake)
{}

ModbusRtuWire::~ModbusRtuWire()
{
    close();
}

Result<void> ModbusRtuWire::open()
{
    close();
    const QString path = portPath(m_settings.serialPort);
    if (const auto hindrance = openingHindrance(path))
        return tl::unexpected(*hindrance);
    auto opened = lock(path);
    if (opened)
        opened = setUp(path);
    if (!opened)
        close();
    return opened;
}

// By a descriptor of its own: the library changes the settings of a port as soon as it opens it, so nobody
// else may have it then. The system lets root open a port that is in use; a lock does not.
Result<void> ModbusRtuWire::lock(const QString &path)
{
    m_lock =
        Descriptor(::open(QFile::encodeName(path).constData(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!m_lock || ::flock(m_lock.get(), LOCK_EX | LOCK_NB) != 0)
        return tl::unexpected(systemRefusal(errno, path));
    return {};
}

Result<void> ModbusRtuWire::setUp(const QString &path)
{
    const SerialSettings &serial = m_settings.serial;
    m_modbus.reset(modbus_new_rtu(QFile::encodeName(path).constData(), serial.baudRate,
                                  parityLetter(serial.parity), serial.dataBits, serial.stopBits));
    if (!m_modbus)
        return tl::unexpected(lineSettingRefusal(QString::number(serial.baudRate)));
    if (modbus_set_slave(m_modbus.get(), m_settings.unit) != 0)
        return tl::unexpected(lineSettingRefusal(QString::number(m_settings.unit)));
    if (modbus_connect(m_modbus.get()) != 0)
        return tl::unexpected(systemRefusal(errno, path));
    const int port = modbus_get_socket(m_modbus.get());
    if (port >= FD_SETSIZE) // the library waits by select(2), which has no place for more
        return tl::unexpected(systemRefusal(EMFILE, path));
    // The library takes a rate that it does not know for 9600.
    if (!setLineRate(port, serial.baudRate))
        return tl::unexpected(lineSettingRefusal(QString::number(serial.baudRate)));
    ::ioctl(port, TIOCEXCL);
    if (serial.lowLatency)
        askForLowLatency(port);
    ::tcflush(port, TCIOFLUSH);
    m_doubt = Doubt::none;
    m_lastByte = steady_clock::now();
    return {};
}

void ModbusRtuWire::close()
{
    if (m_modbus) // which is there only if the port is ours
        ::ioctl(m_lock.get(), TIOCNXCL);
    m_modbus.reset();
    m_lock.close();
}

ModbusRtuWire::Failed ModbusRtuWire::failed(RegisterError error)
{
    if (error.kind == ErrorKind::closed)
        close();
    return tl::unexpected(std::move(error));
}

// The time-out is that of the unit; what the characters need on the line comes on top of it.
tl::expected<Message, RegisterError> ModbusRtuWire::exchange(const Message &request)
{
    if (!m_modbus)
        return failed(registerError(ErrorKind::closed));
    if (auto gap = waitForGap(); !gap)
        return failed(gap.error());
    if (auto quiet = m_doubt == Doubt::none ? RegisterPort::Done() : waitForQuiet(); !quiet)
        return failed(quiet.error());
    const bool mayOldOneCome = std::exchange(m_doubt, Doubt::unanswered) == Doubt::unanswered;
    auto answer = ask(request);
    if (!answer)
        return failed(answer.error());
    m_doubt = Doubt::none;
    m_lastByte = steady_clock::now();
    if (auto gap = mayOldOneCome ? waitForGap() : RegisterPort::Done(); !gap) {
        m_doubt = Doubt::unanswered;
        return failed(gap.error());
    }
    if (m_doubt == Doubt::noise && !isSame(*answer, receive(m_settings.timeOut))) {
        m_doubt = Doubt::unanswered; // whichever of the two is the right one
        return modbus_message::wrongAnswer(GatewayTexts::tr("another one follows it"));
    }
    return answer;
}

tl::expected<Message, RegisterError> ModbusRtuWire::ask(const Message &request)
{
    const auto timeOf = [this](std::size_t length) {
        return m_settings.serial.timeOf(static_cast<int>(length) + frameOverhead);
    };
    const Time until = steady_clock::now() + timeOf(request.size()) + m_settings.timeOut;
    if (auto sent = send(request); !sent)
        return tl::unexpected(sent.error());
    const auto silent = isQuietUntil(until);
    if (!silent)
        return tl::unexpected(silent.error());
    if (*silent)
        return tl::unexpected(registerError(ErrorKind::noAnswer));
    return receive(std::chrono::ceil<Instant>(until - steady_clock::now()) +
                   timeOf(modbus_message::answerLength(request)));
}

tl::expected<bool, RegisterError> ModbusRtuWire::isQuietUntil(Time time)
{
    const Waited waited = waitFor(modbus_get_socket(m_modbus.get()), POLLIN, m_wake, time);
    if (waited == Waited::woken)
        return tl::unexpected(registerError(ErrorKind::stopped));
    return waited == Waited::timeOut;
}

RegisterPort::Done ModbusRtuWire::waitForGap()
{
    const auto isQuiet =
        isQuietUntil(m_lastByte + std::max(m_settings.serial.timeOf(gapCharacters), shortestGap));
    if (!isQuiet)
        return tl::unexpected(isQuiet.error());
    if (!*isQuiet && m_doubt == Doubt::none)
        m_doubt = Doubt::noise;
    return {};
}

RegisterPort::Done ModbusRtuWire::waitForQuiet()
{
    const Time end = steady_clock::now() + longestQuietWait * m_settings.timeOut;
    for (;;) {
        const auto isQuiet = isQuietUntil(steady_clock::now() + m_settings.timeOut);
        if (!isQuiet)
            return tl::unexpected(isQuiet.error());
        if (*isQuiet)
            return {};
        if (auto dropped = drop(); !dropped)
            return dropped;
        if (steady_clock::now() >= end)
            return modbus_message::wrongAnswer(
                GatewayTexts::tr("something on the line does not stop sending"));
    }
}

RegisterPort::Done ModbusRtuWire::drop()
{
    std::array<char, MODBUS_RTU_MAX_ADU_LENGTH> bytes{};
    const auto dropped = ::read(modbus_get_socket(m_modbus.get()), bytes.data(), bytes.size());
    if (dropped > 0 || (dropped < 0 && errno == EAGAIN))
        return {};
    return tl::unexpected(closedError(dropped < 0 ? errno : EIO));
}

RegisterPort::Done ModbusRtuWire::send(const Message &request)
{
    Message raw{static_cast<std::uint8_t>(m_settings.unit)};
    raw.insert(raw.end(), request.begin(), request.end());
    if (modbus_send_raw_request(m_modbus.get(), raw.data(), static_cast<int>(raw.size())) >= 0)
        return {};
    // A line that takes no more, or not all: nobody will answer that.
    if (errno == EAGAIN || errno > MODBUS_ENOBASE)
        return tl::unexpected(registerError(ErrorKind::noAnswer));
    return tl::unexpected(closedError(errno));
}

// What has begun to come. The library checks its checksum, and answers 0 if another unit sent it.
tl::expected<Message, RegisterError> ModbusRtuWire::receive(Instant time)
{
    std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> frame{};
    setAnswerTime(m_modbus.get(), time);
    const int received = modbus_receive_confirmation(m_modbus.get(), frame.data());
    if (received < 0)
        return tl::unexpected(answerError(errno));
    if (received == 0 || frame[0] != m_settings.unit)
        return modbus_message::wrongAnswer(
            sentence(GatewayTexts::tr("it is of unit %1"), {QString::number(frame[0])}));
    return Message(frame.begin() + 1, frame.begin() + received - 2);
}

} // namespace codewheel
