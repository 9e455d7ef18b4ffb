// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line/byte_link.h"
#include "links/low_latency.h"
#include "links/wake_flag.h"

#include <chrono>
#include <memory>

class QSerialPort;

namespace codewheel {

// The link to a serial port of this computer, or to anything that has a path and behaves as one, such as a
// pseudo terminal. Modem lines are not used and may be missing. The port is held exclusively. It is opened,
// used and closed by one thread, which needs no event loop.
class SerialPortLink final : public ByteLink
{
public:
    // A name as in the list of ports, or a path.
    explicit SerialPortLink(const QString &port);
    ~SerialPortLink() override;

    QString name() const override { return m_path; } // its path
    // Of the port as it is open now.
    LowLatency lowLatency() const { return m_lowLatency; }

    // Refused: portNotFound, portNoRights, portInUse, lineSettingWrong, linkFailed (what the system says).
    Result<void> open(const LineSettings &settings) override;
    void close() override;
    Result<void> setBaudRate(int baudRate) override;
    Instant now() const override;
    // These refuse portLost once when the adapter is gone, and lineClosed from then on.
    Result<void> write(const QByteArray &bytes) override;
    Result<QByteArray> read(Instant until) override;
    void interrupt() override { m_wake.raise(); }

private:
    struct Port;
    struct Waited
    {
        bool woken = false;
        bool hungUp = false;
    };

    Result<void> prepare(QSerialPort &port, const LineSettings &settings);
    Waited waitUntil(Instant until);
    tl::unexpected<Refusal> lost();

    QString m_path;
    std::unique_ptr<Port> m_port; // null: not open
    WakeFlag m_wake;
    LowLatency m_lowLatency = LowLatency::notApplicable;
    std::chrono::steady_clock::time_point m_opened;
};

} // namespace codewheel
