// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/can_interface.h"
#include "links/wake_flag.h"

#include <chrono>
#include <deque>
#include <functional>
#include <memory>

class QCanBusDevice;
class QCanBusFrame;

namespace codewheel {

// Qt's device for a SocketCAN interface; null: it has no plugin for it.
std::unique_ptr<QCanBusDevice> socketCanDevice(const QString &interface);

// The link to a CAN bus through an interface of the system. Its rate, and whether it only listens, are the
// system's. It is opened, used and closed by one thread, which needs no event loop.
class SocketCanLink final : public CanLink
{
public:
    using MakeDevice = std::function<std::unique_ptr<QCanBusDevice>(const QString &interface)>;
    using Look = std::function<std::optional<CanInterface>(const QString &interface)>;

    explicit SocketCanLink(
        QString interface, MakeDevice make = socketCanDevice,
        Look look = [](const QString &name) { return canInterface(name); });
    ~SocketCanLink() override;

    // Refused: interfaceMissing, interfaceDown, busOff (until the system ends it), watchNotSure,
    // pluginMissing, notInKernel, linkFailed (what the system says).
    Result<void> open(CanUse use) override;
    void close() override;
    void takeUnsureWatch() override { m_takesUnsureWatch = true; }
    Instant now() const override;
    void wait(Instant until) override;
    // Refuses interfaceLost once when it is gone or switched off, and lineClosed from then on.
    Result<CanNews> receive(Instant until) override;
    // Refused: lineClosed, onlyWatches, busOff, interfaceLost, linkFailed.
    Result<bool> send(const CanFrame &frame) override;
    CanStatus status() const override { return m_status; }
    QString name() const override { return m_interface; }
    void interrupt() override { m_wake.raise(); }

private:
    struct Port;
    struct Sent
    {
        CanFrame frame;
        Instant until;
        std::optional<CanFate> fate{};
    };

    std::optional<Refusal> openingRefusal(const std::optional<CanInterface> &found, CanUse use) const;
    Refusal deviceRefusal(const QString &errorText) const;
    bool waitForFrames(Instant until); // false: it was interrupted
    void takeFrames(CanNews &news);
    void takeError(const CanFrame &frame);
    void takeEcho(const CanFrame &frame);
    void tellFates(CanNews &news);
    bool isThere(); // also takes its status
    tl::unexpected<Refusal> lost();
    Instant timeOf(const QCanBusFrame &frame);

    const QString m_interface;
    const MakeDevice m_make;
    const Look m_look;
    std::unique_ptr<Port> m_port; // null: not open
    CanUse m_use = CanUse::watch;
    bool m_takesUnsureWatch = false;
    bool m_isConfirming = false;
    CanStatus m_status{};
    std::deque<Sent> m_sent{}; // without a fate that was told
    Instant m_nextLook{};
    Instant m_lastTime{}; // of a frame
    WakeFlag m_wake;
    const std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

} // namespace codewheel
