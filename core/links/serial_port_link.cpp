// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/serial_port_link.h"

#include "links/descriptor.h"
#include "links/port_access.h"
#include "links/port_driver.h"
#include "links/wait_for.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>

namespace codewheel {
namespace {

using std::chrono::steady_clock;

constexpr int longestWrite = 1'000;       // ms without a byte taken by the system
constexpr std::size_t mostOfLine = 4'096; // bytes; the system keeps as many of a line

bool isPassing(int errorNumber)
{
    return errorNumber == EAGAIN || errorNumber == EINTR;
}

Refusal systemRefusal(RefusalCode id, const QString &path)
{
    return portRefusal(id, path, QString::fromLocal8Bit(std::strerror(errno)));
}

tl::unexpected<Refusal> settingRefused(int setting)
{
    return tl::unexpected(lineSettingRefusal(QString::number(setting)));
}

Result<void> checkSettings(const SerialSettings &settings)
{
    if (settings.baudRate <= 0)
        return settingRefused(settings.baudRate);
    if (settings.dataBits != 7 && settings.dataBits != 8)
        return settingRefused(settings.dataBits);
    if (settings.stopBits != 1 && settings.stopBits != 2)
        return settingRefused(settings.stopBits);
    return {};
}

// It has none, and refuses every further change once one was set.
bool isPseudoTerminal(const QString &path)
{
    return QFileInfo(path).canonicalFilePath().startsWith(QStringLiteral("/dev/pts/"));
}

tcflag_t flagsOf(const SerialSettings &settings, bool hasParity)
{
    using Parity = SerialSettings::Parity;
    tcflag_t flags = CLOCAL | CREAD;
    flags |= settings.dataBits == 7 ? CS7 : CS8;
    flags |= settings.stopBits == 2 ? CSTOPB : 0U;
    if (hasParity && settings.parity != Parity::none)
        flags |= settings.parity == Parity::odd ? PARENB | PARODD : PARENB;
    return flags;
}

// Bytes as they are, without modem lines.
termios rawLine(termios line, tcflag_t flags)
{
    constexpr tcflag_t ours = CSIZE | CSTOPB | PARENB | PARODD | CRTSCTS | CLOCAL | CREAD;
    ::cfmakeraw(&line);
    line.c_cflag = (line.c_cflag & ~ours) | flags;
    return line;
}

bool setRate(int port, int baudRate)
{
    termios line = {};
    if (::tcgetattr(port, &line) != 0)
        return false;
    ::cfsetspeed(&line, static_cast<speed_t>(baudRate)); // if there is a constant for it
    return ::tcsetattr(port, TCSANOW, &line) == 0 && setLineRate(port, baudRate);
}

} // namespace

// Gets back the settings it had.
struct SerialPortLink::Port
{
    explicit Port(Descriptor opened)
        : line(std::move(opened))
    {
        ::ioctl(line.get(), TIOCEXCL);
        ::tcgetattr(line.get(), &before);
    }
    ~Port()
    {
        ::tcsetattr(line.get(), TCSANOW, &before);
        ::ioctl(line.get(), TIOCNXCL);
    }
    Port(const Port &) = delete;
    Port &operator=(const Port &) = delete;

    Descriptor line;
    termios before = {};
};

SerialPortLink::SerialPortLink(const QString &port)
    : SerialPortLink(KeptAdapter(portPath(port)))
{}

SerialPortLink::SerialPortLink(const KeptAdapter &adapter, PortList ports)
    : m_ports(std::move(ports))
    , m_adapter(adapter)
{}

SerialPortLink::~SerialPortLink() = default;

QString SerialPortLink::name() const
{
    const std::scoped_lock lock(m_adapterMutex);
    return m_adapter.path();
}

std::optional<PortInfo> SerialPortLink::adapter() const
{
    const std::scoped_lock lock(m_adapterMutex);
    return m_adapter.adapter();
}

void SerialPortLink::takeOtherAdapter()
{
    const std::scoped_lock lock(m_adapterMutex);
    m_adapter.takeOther();
}

Result<QString> SerialPortLink::findPort()
{
    const std::vector<PortInfo> present = m_ports();
    const std::scoped_lock lock(m_adapterMutex);
    return m_adapter.find(present);
}

Result<void> SerialPortLink::open(const SerialSettings &settings)
{
    const bool wasOurs = m_port != nullptr; // for us alone, so nobody else has it now
    close();
    const Result<QString> path = findPort();
    if (!path)
        return tl::unexpected(path.error());
    if (const auto hindrance = wasOurs ? portHindrance(*path) : openingHindrance(*path))
        return tl::unexpected(*hindrance);
    if (auto checked = checkSettings(settings); !checked)
        return checked;
    Descriptor line(::open(QFile::encodeName(*path).constData(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    // The system lets root open a port that is in use; a lock does not.
    if (!line || ::flock(line.get(), LOCK_EX | LOCK_NB) != 0)
        return tl::unexpected(systemRefusal(portRefusalOf(errno), *path));
    auto port = std::make_unique<Port>(std::move(line));
    const int its = port->line.get();
    const termios raw = rawLine(port->before, flagsOf(settings, !isPseudoTerminal(*path)));
    if (::tcsetattr(its, TCSANOW, &raw) != 0)
        return tl::unexpected(systemRefusal(RefusalId::linkFailed, *path));
    if (!setRate(its, settings.baudRate))
        return settingRefused(settings.baudRate);
    ::tcflush(its, TCIOFLUSH);
    m_lowLatency = settings.lowLatency ? askForLowLatency(its) : LowLatency::notAsked;
    m_port = std::move(port);
    return {};
}

void SerialPortLink::close()
{
    m_port.reset();
}

Result<void> SerialPortLink::setBaudRate(int baudRate)
{
    if (!m_port)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    return baudRate > 0 && setRate(m_port->line.get(), baudRate) ? Result<void>() : settingRefused(baudRate);
}

Instant SerialPortLink::now() const
{
    return std::chrono::duration_cast<Instant>(steady_clock::now() - m_begin);
}

Result<void> SerialPortLink::write(const QByteArray &bytes)
{
    if (!m_port)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    QByteArrayView left = bytes;
    while (!left.isEmpty()) {
        const auto written = ::write(m_port->line.get(), left.data(), static_cast<std::size_t>(left.size()));
        if (written < 0 && !isPassing(errno))
            return lost();
        left = left.sliced(std::max<qsizetype>(written, 0));
        pollfd waited{m_port->line.get(), POLLOUT, 0};
        if (left.isEmpty() || ::poll(&waited, 1, longestWrite) != 0)
            continue;
        ::tcflush(m_port->line.get(), TCOFLUSH);
        errno = ETIME;
        return tl::unexpected(systemRefusal(RefusalId::linkFailed, name()));
    }
    return {};
}

Result<QByteArray> SerialPortLink::read(Instant until)
{
    if (!m_port)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    while (waitUntil(until)) {
        std::array<char, mostOfLine> bytes; // NOLINT(*-member-init): it is filled
        const auto count = ::read(m_port->line.get(), bytes.data(), bytes.size());
        if (count > 0)
            return QByteArray(bytes.data(), count);
        if (count == 0 || !isPassing(errno))
            return lost();
    }
    return QByteArray();
}

// For bytes or the end of the port.
bool SerialPortLink::waitUntil(Instant until)
{
    const Waited waited = waitFor(m_port ? m_port->line.get() : -1, POLLIN, m_wake, m_begin + until);
    m_wasInterrupted = waited == Waited::woken;
    return waited == Waited::ready;
}

tl::unexpected<Refusal> SerialPortLink::lost()
{
    close();
    return refuse(RefusalKind::link, RefusalId::portLost, {name()});
}

} // namespace codewheel
