// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/simulator/simulated_esc_line.h"
#include "serial/byte_link.h"

#include <functional>
#include <memory>

namespace codewheel {

// The link to a simulated serial line. Without a clock its time is virtual: it passes only in read() and
// wait(), which return at once, read() with one byte after another. With a clock, it keeps to its time and
// waits; bytes without a gap between them are handed over together, as an adapter does.
class SimulatedEscLineLink final : public ByteLink
{
public:
    using Clock = std::function<Instant()>; // with any starting point; never goes back

    explicit SimulatedEscLineLink(std::shared_ptr<SimulatedEscLine> line, Clock clock = {});

    // Refused: portNotFound while the adapter is unplugged; after that portLost, once, then lineClosed.
    Result<void> open(const SerialSettings &settings) override;
    void close() override { m_open = false; }
    Result<void> setBaudRate(int baudRate) override;
    Instant now() const override { return m_clock ? m_clock() - m_begin : m_now; }
    void wait(Instant until) override;
    Result<void> write(const QByteArray &bytes) override;
    Result<QByteArray> read(Instant until) override;
    QString name() const override;
    bool isSimulated() const override { return true; }
    void interrupt() override { m_line->wake(); }

private:
    Result<void> usable();
    QByteArray readVirtually(Instant until);
    QByteArray readReally(Instant until);

    std::shared_ptr<SimulatedEscLine> m_line;
    const Clock m_clock;
    Instant m_now{};       // of virtual time
    const Instant m_begin; // on the clock
    bool m_open = false;
};

} // namespace codewheel
