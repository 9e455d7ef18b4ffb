// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_work.h"

#include <memory>
#include <utility>

namespace codewheel {

// The runner of a bus whose encoders are asked; what it does is an AskingWork, which its files share.
template <class Command, class BusEvent, class Snapshot>
class AskingRunner : public BusRunner<Command, BusEvent, Snapshot>
{
public:
    Result<void> open(const std::stop_token &stop) override { return m_work->open(stop); }
    void turn(Instant until) override { m_work->turn(until); }
    void slept(std::chrono::milliseconds duration) override { m_work->slept(duration); }
    void close() override { m_work->close(); }
    Instant now() const override { return m_work->now(); }
    void interrupt() override { m_work->interrupt(); }
    void post(Command command) override // does not wait for what the bus is doing
    {
        BusRunner<Command, BusEvent, Snapshot>::post(std::move(command));
        interrupt();
    }

protected:
    std::unique_ptr<BusWork> m_work; // an AskingWork
};

} // namespace codewheel
