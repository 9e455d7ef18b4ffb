// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/serial_port_link.h"

#include "links/descriptor.h"
#include "links/low_latency.h"
#include "links/port_access.h"

#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QSerialPort>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>

namespace codewheel {
namespace {

using std::chrono::steady_clock;

constexpr int longestWrite = 1'000; // ms without a byte taken by the system

// For Qt, a port in use by somebody else and one the user has no rights to are the same error; the rights
// were checked before.
int errorNumberOf(QSerialPort::SerialPortError error)
{
    switch (error) {
    case QSerialPort::DeviceNotFoundError:
        return ENOENT;
    case QSerialPort::PermissionError:
        return EBUSY;
    default:
        return EIO;
    }
}

tl::unexpected<Refusal> settingRefused(int setting)
{
    return tl::unexpected(lineSettingRefusal(QString::number(setting)));
}

QSerialPort::Parity parityOf(SerialSettings::Parity parity)
{
    switch (parity) {
    case SerialSettings::Parity::none:
        return QSerialPort::NoParity;
    case SerialSettings::Parity::even:
        return QSerialPort::EvenParity;
    case SerialSettings::Parity::odd:
        return QSerialPort::OddParity;
    }
    return QSerialPort::NoParity;
}

// It has none, and refuses one once it was set.
bool isPseudoTerminal(const QString &path)
{
    return QFileInfo(path).canonicalFilePath().startsWith(QStringLiteral("/dev/pts/"));
}

bool isFailure(QSerialPort::SerialPortError error)
{
    return error != QSerialPort::NoError && error != QSerialPort::TimeoutError;
}

} // namespace

// Qt's port wants an event dispatcher in its thread, though nobody runs it here; a loop brings one along.
struct SerialPortLink::Port
{
    QEventLoop dispatcher;
    Descriptor lock;
    QSerialPort serial;
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
    auto port = std::make_unique<Port>();
    if (auto prepared = prepare(port->serial, *path, settings); !prepared)
        return prepared;
    // The system lets root open a port that is in use; a lock does not. By a descriptor of its own: Qt
    // changes the settings of a port as soon as it opens it, so nobody else may have it then.
    port->lock =
        Descriptor(::open(QFile::encodeName(*path).constData(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!port->lock || ::flock(port->lock.get(), LOCK_EX | LOCK_NB) != 0)
        return tl::unexpected(
            portRefusal(portRefusalOf(errno), *path, QString::fromLocal8Bit(std::strerror(errno))));
    if (!port->serial.open(QIODevice::ReadWrite))
        return tl::unexpected(portRefusal(portRefusalOf(errorNumberOf(port->serial.error())), *path,
                                          port->serial.errorString()));
    if (port->serial.baudRate() != settings.baudRate)
        return settingRefused(settings.baudRate);
    port->serial.clear();
    m_lowLatency = settings.lowLatency ? askForLowLatency(static_cast<int>(port->serial.handle()))
                                       : LowLatency::notAsked;
    m_port = std::move(port);
    return {};
}

// Before it is opened: afterwards a port without modem lines does not accept a parity any more.
Result<void> SerialPortLink::prepare(QSerialPort &port, const QString &path, const SerialSettings &settings)
{
    port.setPortName(path);
    if (settings.baudRate <= 0 || !port.setBaudRate(settings.baudRate))
        return settingRefused(settings.baudRate);
    if ((settings.dataBits != 7 && settings.dataBits != 8) ||
        !port.setDataBits(static_cast<QSerialPort::DataBits>(settings.dataBits)))
        return settingRefused(settings.dataBits);
    if ((settings.stopBits != 1 && settings.stopBits != 2) ||
        !port.setStopBits(static_cast<QSerialPort::StopBits>(settings.stopBits)))
        return settingRefused(settings.stopBits);
    port.setParity(isPseudoTerminal(path) ? QSerialPort::NoParity : parityOf(settings.parity));
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
    if (baudRate <= 0 || !m_port->serial.setBaudRate(baudRate))
        return settingRefused(baudRate);
    return {};
}

Instant SerialPortLink::now() const
{
    return std::chrono::duration_cast<Instant>(steady_clock::now() - m_begin);
}

Result<void> SerialPortLink::write(const QByteArray &bytes)
{
    if (!m_port)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    QSerialPort &serial = m_port->serial;
    serial.write(bytes);
    while (serial.bytesToWrite() > 0)
        if (!serial.waitForBytesWritten(longestWrite)) {
            if (isFailure(serial.error()))
                return lost();
            serial.clear(QSerialPort::Output);
            return tl::unexpected(portRefusal(RefusalId::linkFailed, name(), serial.errorString()));
        }
    return {};
}

Result<QByteArray> SerialPortLink::read(Instant until)
{
    if (!m_port)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    QSerialPort &serial = m_port->serial;
    while (true) {
        const bool hasHungUp = waitUntil(until);
        if (m_wasInterrupted)
            return QByteArray();
        if (serial.waitForReadyRead(0) || serial.bytesAvailable() > 0)
            return serial.readAll();
        if (hasHungUp || isFailure(serial.error()))
            return lost();
        if (now() >= until)
            return QByteArray();
    }
}

void SerialPortLink::wait(Instant until)
{
    waitUntil(until);
}

// For bytes, the flag, or the end of the port. Another thread cannot end Qt's own wait.
bool SerialPortLink::waitUntil(Instant until)
{
    using namespace std::chrono;
    const nanoseconds left = std::max(until - now(), Instant{});
    const timespec timeOut{duration_cast<seconds>(left).count(), (left % 1s).count()};
    std::array<pollfd, 2> waited{
        {{m_port ? static_cast<int>(m_port->serial.handle()) : -1, POLLIN, 0}, // -1 is ignored
         {m_wake.descriptor(), POLLIN, 0}}};
    ::ppoll(waited.data(), waited.size(), &timeOut, nullptr);
    m_wasInterrupted = m_wake.lower();
    return (waited[0].revents & (POLLERR | POLLHUP | POLLNVAL)) != 0;
}

tl::unexpected<Refusal> SerialPortLink::lost()
{
    close();
    return refuse(RefusalKind::link, RefusalId::portLost, {name()});
}

} // namespace codewheel
