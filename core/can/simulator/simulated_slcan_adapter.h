// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/simulator/simulated_can_link.h"
#include "can/slcan_codec.h"

namespace codewheel {

// An SLCAN adapter on a simulated CAN bus, seen from its serial port: commands come in, answers and frames go
// out, as with Lawicel's firmware (V1013). Time is an argument, and is that of the bus. Used by the command
// serve.
class SimulatedSlcanAdapter
{
public:
    static constexpr qsizetype mostUnfetched = 16'384; // bytes; then frames are lost

    explicit SimulatedSlcanAdapter(std::shared_ptr<SimulatedCanBus> bus);
    SimulatedSlcanAdapter(const SimulatedSlcanAdapter &) = delete;
    SimulatedSlcanAdapter &operator=(const SimulatedSlcanAdapter &) = delete;

    // Lets the time of the bus pass up to `now`, and takes what was received meanwhile.
    void advance(Instant now);
    // What a program has written to the port.
    void take(const QByteArray &bytes, Instant now);
    // What is to be read there, until it was fetched.
    const QByteArray &unfetched() const { return m_out; }
    void fetched(qsizetype bytes) { m_out.remove(0, bytes); }
    // As when it is plugged in: closed, without a rate.
    void restart();

private:
    bool obey(const SlcanItem &item); // false: refused
    bool command(const QByteArray &text);
    bool setRate(char digit);
    bool open(CanUse use);
    bool close();
    bool send(const SlcanItem &item);
    bool setStamps(const QByteArray &digit);
    bool tellStatus();
    bool tell(const QByteArray &text);
    void deliver(const CanFrame &frame);

    std::shared_ptr<SimulatedCanBus> m_bus;
    Instant m_now{};
    Instant m_openedAt{};
    std::unique_ptr<SimulatedCanLink> m_link; // null: the bus is closed
    int m_rate = 0;                           // Bd; 0: not set
    bool m_hasStamps = false;
    std::uint8_t m_status = 0; // what F tells once
    SlcanReader m_reader;
    QByteArray m_out;
};

} // namespace codewheel
