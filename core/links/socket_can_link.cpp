// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/socket_can_link.h"

#include "can/can_refusals.h"
#include "links/wait_for.h"

#include <QCanBus>
#include <QCanBusDevice>
#include <QEventLoop>
#include <QLoggingCategory>
#include <QSocketNotifier>
#include <QTimer>
#include <QVariant>

#include <algorithm>
#include <cerrno>
#include <linux/can/error.h>
#include <mutex>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr Instant lookInterval = 200ms; // Qt's device does not say that its interface is gone
constexpr Instant echoTimeOut = 1s;     // assumed

bool isError(const QString &text, std::initializer_list<int> errorNumbers)
{
    return std::ranges::any_of(errorNumbers, [&](int number) { return text == qt_error_string(number); });
}

CanFrame frameOfQt(const QCanBusFrame &from)
{
    CanFrame frame{
        .id = from.frameType() == QCanBusFrame::ErrorFrame ? static_cast<std::uint32_t>(from.error().toInt())
                                                           : from.frameId(),
        .isExtended = from.hasExtendedFrameFormat() && from.frameType() != QCanBusFrame::ErrorFrame,
        .isRemote = from.frameType() == QCanBusFrame::RemoteRequestFrame,
        .isError = from.frameType() == QCanBusFrame::ErrorFrame};
    const QByteArray data =
        from.payload().first(std::min<qsizetype>(from.payload().size(), CanFrame::mostBytes));
    frame.length = static_cast<std::uint8_t>(data.size());
    if (!frame.isRemote)
        std::ranges::copy(data, frame.bytes.begin());
    return frame;
}

// The length of a remote frame is that of its data, though none is sent.
QCanBusFrame frameForQt(const CanFrame &from)
{
    const QByteArray data(reinterpret_cast<const char *>(from.bytes.data()), from.length);
    QCanBusFrame frame(from.id, from.isRemote ? QByteArray(from.length, '\0') : data);
    frame.setExtendedFrameFormat(from.isExtended);
    if (from.isRemote)
        frame.setFrameType(QCanBusFrame::RemoteRequestFrame);
    return frame;
}

QLoggingCategory::CategoryFilter usualFilter = nullptr;

// The plugin warns of a library that it only needs for what it is never asked here.
void withoutPlugin(QLoggingCategory *category)
{
    usualFilter(category);
    if (qstrcmp(category->categoryName(), "qt.canbus.plugins.socketcan") == 0)
        for (const QtMsgType type : {QtInfoMsg, QtWarningMsg})
            category->setEnabled(type, false);
}

} // namespace

std::unique_ptr<QCanBusDevice> socketCanDevice(const QString &interface)
{
    static std::once_flag once;
    std::call_once(once, [] { usualFilter = QLoggingCategory::installFilter(withoutPlugin); });
    QString said;
    return std::unique_ptr<QCanBusDevice>(
        QCanBus::instance()->createDevice(QStringLiteral("socketcan"), interface, &said));
}

// The device wants an event dispatcher in its thread; a loop brings one along.
struct SocketCanLink::Port
{
    QEventLoop loop;
    std::unique_ptr<QCanBusDevice> device;
};

SocketCanLink::SocketCanLink(QString interface, MakeDevice make, Look look)
    : m_interface(std::move(interface))
    , m_make(std::move(make))
    , m_look(std::move(look))
{}

SocketCanLink::~SocketCanLink() = default;

Result<void> SocketCanLink::open(CanUse use)
{
    close();
    const std::optional<CanInterface> found = m_look(m_interface);
    if (auto refusal = openingRefusal(found, use))
        return tl::unexpected(*std::move(refusal));
    auto port = std::make_unique<Port>();
    port->device = m_make(m_interface);
    if (!port->device)
        return refuse(RefusalKind::link, CanRefusalId::pluginMissing);
    port->device->setConfigurationParameter(QCanBusDevice::ReceiveOwnKey, true);
    if (!port->device->connectDevice())
        return tl::unexpected(deviceRefusal(port->device->errorString()));
    m_port = std::move(port);
    m_use = use;
    m_isConfirming = found->isConfirming;
    m_status = found->status;
    m_nextLook = now() + lookInterval;
    return {};
}

std::optional<Refusal> SocketCanLink::openingRefusal(const std::optional<CanInterface> &found,
                                                     CanUse use) const
{
    if (!found)
        return Refusal{RefusalKind::link, CanRefusalId::interfaceMissing, {m_interface}};
    if (!found->isUp)
        return Refusal{RefusalKind::link,
                       CanRefusalId::interfaceDown,
                       {m_interface, switchOnCommand(*found, proposedCanRate)}};
    if (found->status.state == CanState::busOff)
        return Refusal{RefusalKind::link, CanRefusalId::busOff, {m_interface, restartCommand(m_interface)}};
    const bool isSure = found->status.listensOnly.value_or(false) || found->isVirtual;
    if (use == CanUse::watch && !isSure && !m_takesUnsureWatch)
        return Refusal{RefusalKind::link,
                       CanRefusalId::watchNotSure,
                       {m_interface, listenOnlyCommand(*found, proposedCanRate)}};
    return std::nullopt;
}

Refusal SocketCanLink::deviceRefusal(const QString &errorText) const
{
    if (isError(errorText, {EAFNOSUPPORT, EPROTONOSUPPORT}))
        return {RefusalKind::link, CanRefusalId::notInKernel, {m_interface}};
    if (isError(errorText, {ENODEV, ENXIO}))
        return {RefusalKind::link, CanRefusalId::interfaceMissing, {m_interface}};
    return {RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("%1: %2").arg(m_interface, errorText)}};
}

void SocketCanLink::close()
{
    if (m_port)
        m_port->device->disconnectDevice();
    m_port.reset();
    m_sent.clear();
    m_status = {};
}

Instant SocketCanLink::now() const
{
    return std::chrono::duration_cast<Instant>(steady_clock::now() - m_begin);
}

void SocketCanLink::wait(Instant until)
{
    waitFor(-1, 0, m_wake, m_begin + until);
}

bool SocketCanLink::waitForFrames(Instant until)
{
    QCanBusDevice &device = *m_port->device;
    QEventLoop &loop = m_port->loop;
    const QSocketNotifier wake(m_wake.descriptor(), QSocketNotifier::Read);
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    const std::array ends{QObject::connect(&wake, &QSocketNotifier::activated, &loop, &QEventLoop::quit),
                          QObject::connect(&timer, &QTimer::timeout, &loop, &QEventLoop::quit),
                          QObject::connect(&device, &QCanBusDevice::framesReceived, &loop, &QEventLoop::quit),
                          QObject::connect(&device, &QCanBusDevice::stateChanged, &loop, &QEventLoop::quit)};
    loop.processEvents();
    if (device.framesAvailable() == 0 && now() < until && device.state() == QCanBusDevice::ConnectedState) {
        timer.start(std::chrono::ceil<std::chrono::milliseconds>(until - now()));
        loop.exec();
    }
    for (const QMetaObject::Connection &end : ends)
        QObject::disconnect(end);
    return !m_wake.lower();
}

Result<CanNews> SocketCanLink::receive(Instant until)
{
    if (!m_port)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    CanNews news;
    bool wasInterrupted = false;
    do {
        wasInterrupted = !waitForFrames(std::min(until, m_nextLook));
        takeFrames(news);
        tellFates(news);
        const bool isNew = !news.frames.empty() || !news.fates.empty();
        if (!isThere() && !isNew)
            return lost();
        if (isNew)
            break;
    } while (!wasInterrupted && now() < until);
    return news;
}

void SocketCanLink::takeFrames(CanNews &news)
{
    for (const QCanBusFrame &from : m_port->device->readAllFrames()) {
        if (from.hasFlexibleDataRateFormat() || !from.isValid())
            continue;
        CanFrame frame = frameOfQt(from);
        if (from.hasLocalEcho()) {
            takeEcho(frame);
            continue;
        }
        if (frame.isError)
            takeError(frame);
        frame.interface = m_interface.toStdString();
        frame.time = timeOf(from);
        news.frames.push_back(std::move(frame));
    }
}

// Qt has the time of day at which the system received it.
Instant SocketCanLink::timeOf(const QCanBusFrame &frame)
{
    using namespace std::chrono;
    const Instant stamp =
        seconds(frame.timeStamp().seconds()) + microseconds(frame.timeStamp().microSeconds());
    const Instant age = duration_cast<Instant>(system_clock::now().time_since_epoch()) - stamp;
    const Instant at = now();
    const bool isPlausible = age >= 0s && age <= at && age < 1min; // unless the clock was set
    m_lastTime = std::max(m_lastTime, isPlausible ? at - age : at);
    return m_lastTime;
}

void SocketCanLink::takeError(const CanFrame &frame)
{
    if ((frame.id & CAN_ERR_CRTL) != 0) {
        const std::uint8_t detail = frame.bytes[1];
        if ((detail & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0)
            m_status.state = CanState::passive;
        else if ((detail & (CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) != 0)
            m_status.state = CanState::warning;
        else if ((detail & CAN_ERR_CRTL_ACTIVE) != 0)
            m_status.state = CanState::active;
    }
    if ((frame.id & CAN_ERR_CNT) != 0) {
        m_status.transmitErrors = frame.bytes[6];
        m_status.receiveErrors = frame.bytes[7];
    }
    if ((frame.id & CAN_ERR_RESTARTED) != 0)
        m_status.state = CanState::active;
    if ((frame.id & CAN_ERR_BUSOFF) != 0) {
        m_status.state = CanState::busOff;
        for (Sent &sent : m_sent) // the driver drops them
            sent.fate = sent.fate.value_or(CanFate::notKnown);
    }
}

// The controller may have sent them in another order.
void SocketCanLink::takeEcho(const CanFrame &frame)
{
    const auto found =
        std::ranges::find_if(m_sent, [&](const Sent &sent) { return !sent.fate && sent.frame == frame; });
    if (found != m_sent.end())
        found->fate = m_isConfirming ? CanFate::done : CanFate::notKnown;
}

void SocketCanLink::tellFates(CanNews &news)
{
    while (!m_sent.empty() && (m_sent.front().fate || m_sent.front().until <= now())) {
        news.fates.push_back(m_sent.front().fate.value_or(CanFate::notKnown));
        m_sent.pop_front();
    }
}

Result<bool> SocketCanLink::send(const CanFrame &frame)
{
    if (!m_port)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    if (m_use == CanUse::watch)
        return refuse(RefusalKind::link, CanRefusalId::onlyWatches, {m_interface});
    if (m_status.state == CanState::busOff)
        return refuse(RefusalKind::link, CanRefusalId::busOff, {m_interface, restartCommand(m_interface)});
    if (m_port->device->state() != QCanBusDevice::ConnectedState)
        return lost();
    Sent sent{.frame = frame, .until = now() + echoTimeOut};
    sent.frame.interface.clear();
    sent.frame.time.reset();
    if (m_port->device->writeFrame(frameForQt(frame))) {
        m_sent.push_back(std::move(sent));
        return true;
    }
    const QString why = m_port->device->errorString();
    if (isError(why, {ENOBUFS, EAGAIN}))
        return false;
    if (isError(why, {ENETDOWN, ENXIO, ENODEV}))
        return lost();
    return tl::unexpected(deviceRefusal(why));
}

bool SocketCanLink::isThere()
{
    if (m_port->device->state() != QCanBusDevice::ConnectedState)
        return false;
    if (now() < m_nextLook)
        return true;
    m_nextLook = now() + lookInterval;
    const std::optional<CanInterface> found = m_look(m_interface);
    if (!found || !found->isUp)
        return false;
    if (found->status != CanStatus())
        m_status = found->status;
    return true;
}

tl::unexpected<Refusal> SocketCanLink::lost()
{
    close();
    return refuse(RefusalKind::link, CanRefusalId::interfaceLost, {m_interface});
}

} // namespace codewheel
