// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_work.h"
#include "kinds/esc/line/esc_line_command.h"
#include "kinds/esc/line/esc_line_event.h"
#include "kinds/esc/line/esc_line_snapshot.h"
#include "serial/byte_link.h"

#include <memory>

namespace codewheel {

// Owns the line: one request at a time. What was typed goes first, then a scan, then the devices in turn: of
// those that want something, the one that has waited longest.
//
// It begins in Watch, where only reads are sent, and without polling. When the port is gone it reports that
// once, ends the jobs, and tries every second to open it again at the same adapter, and at no other unasked.
// Once it is back the line is in Watch.
class EscLineRunner final : public BusRunner<EscLineCommand, EscLineEvent, EscLineSnapshot>
{
public:
    EscLineRunner(ByteLink &link, const SerialSettings &settings, const esc::Timing &timing);
    ~EscLineRunner() override;

    Result<void> open(const std::stop_token &stop) override;
    void turn(Instant until) override;
    void slept(std::chrono::milliseconds duration) override;
    void close() override;
    Instant now() const override;
    void interrupt() override;
    void post(EscLineCommand command) override; // does not wait for what the line is doing

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace codewheel
