// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/kept_adapter.h"
#include "links/wake_flag.h"
#include "serial/byte_link.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>

namespace codewheel {

// The link to a serial port of this computer, or to anything that has a path and behaves like one, such as a
// pseudo terminal. Modem lines are not used and may be missing. The port is held exclusively. One thread may
// open it and another one go on with it; none needs an event loop.
class SerialPortLink final : public ByteLink
{
public:
    using PortList = std::function<std::vector<PortInfo>()>;

    // A name as in the list of ports, or a path.
    explicit SerialPortLink(const QString &port);
    // At this adapter from the beginning, wherever it is plugged in.
    explicit SerialPortLink(const KeptAdapter &adapter, PortList ports = serialPorts);
    ~SerialPortLink() override;

    QString name() const override; // the path of the port; changes if the adapter is plugged in elsewhere
    LowLatency lowLatency() const override { return m_lowLatency; }
    // The one it is or was opened at; empty if the path has none. Any thread.
    std::optional<PortInfo> adapter() const;

    // Refused: portNotFound, portOfOther, portNoRights, portInUse, lineSettingWrong, linkFailed (what the
    // system says).
    Result<void> open(const SerialSettings &settings) override;
    void close() override;
    Result<void> setBaudRate(int baudRate) override;
    void takeOtherAdapter() override;
    Instant now() const override;
    void wait(Instant until) override { waitUntil(until); }
    // These refuse portLost once when the adapter is gone, and lineClosed from then on.
    Result<void> write(const QByteArray &bytes) override;
    Result<QByteArray> read(Instant until) override;
    void interrupt() override { m_wake.raise(); }
    // The last read() or wait() ended early because of it.
    bool wasInterrupted() const { return m_wasInterrupted; }

private:
    struct Port;
    Result<QString> findPort();
    bool waitUntil(Instant until); // false: the time is over, or it was interrupted
    tl::unexpected<Refusal> lost();

    const PortList m_ports;
    mutable std::mutex m_adapterMutex;
    KeptAdapter m_adapter;
    std::unique_ptr<Port> m_port; // null: not open
    WakeFlag m_wake;
    bool m_wasInterrupted = false;
    std::atomic<LowLatency> m_lowLatency = LowLatency::notApplicable;
    const std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

} // namespace codewheel
