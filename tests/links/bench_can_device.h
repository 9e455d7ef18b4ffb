// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/can_interface.h"

#include <QCanBusDevice>
#include <QCanBusFrame>
#include <QVariant>

#include <cerrno>
#include <memory>

namespace codewheel::test {

// What is behind a simulated SocketCAN interface. It outlives the devices that are opened at it.
struct BenchCanBus
{
    std::optional<CanInterface> interface = CanInterface{
        .name = QStringLiteral("can7"), .isUp = true, .isConfirming = true, .status = {.rate = 125'000}};
    int openError = 0;
    int writeError = 0; // errno of the system
    bool isAcknowledged = true;
    QList<QCanBusFrame> written{}; // not acknowledged yet
    QList<QCanBusFrame> heard{};
    class BenchCanDevice *device = nullptr; // that is open
};

// Behaves as Qt's plugin for SocketCAN in Qt 6.4: what it has sent comes back with a mark, and it says
// nothing when its interface goes.
class BenchCanDevice final : public QCanBusDevice
{
public:
    explicit BenchCanDevice(std::shared_ptr<BenchCanBus> bus)
        : m_bus(std::move(bus))
    {}
    ~BenchCanDevice() override { m_bus->device = nullptr; }

    bool writeFrame(const QCanBusFrame &frame) override
    {
        if (m_bus->writeError != 0) {
            setError(qt_error_string(m_bus->writeError), WriteError);
            return false;
        }
        if (m_bus->isAcknowledged) {
            m_bus->heard << frame;
            echo(frame);
            return true;
        }
        constexpr int mostWaiting = 10;
        if (m_bus->written.size() == mostWaiting) {
            setError(qt_error_string(ENOBUFS), WriteError);
            return false;
        }
        m_bus->written << frame;
        return true;
    }
    QString interpretErrorFrame(const QCanBusFrame &) override { return {}; }
    void bring(QCanBusFrame frame)
    {
        const Instant now = std::chrono::duration_cast<Instant>(
            std::chrono::system_clock::now().time_since_epoch()); // as the system stamps them
        frame.setTimeStamp(QCanBusFrame::TimeStamp::fromMicroSeconds(now.count()));
        enqueueReceivedFrames({frame});
    }
    void echo(QCanBusFrame frame)
    {
        if (!configurationParameter(ReceiveOwnKey).toBool())
            return;
        frame.setLocalEcho(true);
        bring(frame);
    }
    // A class and the first bytes of linux/can/error.h.
    void bringError(QCanBusFrame::FrameErrors error, const QByteArray &details)
    {
        QCanBusFrame frame(QCanBusFrame::ErrorFrame);
        frame.setError(error);
        frame.setPayload(details.leftJustified(8, '\0'));
        bring(frame);
    }

protected:
    bool open() override
    {
        if (m_bus->openError != 0) {
            setError(qt_error_string(m_bus->openError), ConnectionError);
            return false;
        }
        m_bus->device = this;
        setState(ConnectedState);
        return true;
    }
    void close() override
    {
        m_bus->device = nullptr;
        setState(UnconnectedState);
    }

private:
    const std::shared_ptr<BenchCanBus> m_bus;
};

} // namespace codewheel::test
