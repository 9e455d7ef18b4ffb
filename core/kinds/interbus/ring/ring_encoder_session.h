// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/encoder_on_bus.h"
#include "kinds/interbus/ring/ring_traffic.h"

namespace codewheel {

class RingSession;

// An encoder of a ring, as views see it: turns jobs into commands for the runner, and what RingSession pumps
// out of the bus thread into signals.
class RingEncoderSession final : public EncoderOnBus
{
    Q_OBJECT

public:
    // `linkBoundsCycles`: a word can be sent for just one bus cycle; without it some jobs are impossible.
    RingEncoderSession(RingSession &bus, std::size_t device, Place number,
                       const DeviceDescription &description, bool linkBoundsCycles);

    // 00000000 is what it shows without power.
    bool showsPosition() const override { return EncoderSession::showsPosition() && latest().in != 0; }
    Result<std::vector<Step>> planned(const std::vector<Job> &jobs) const override;

private:
    friend class RingSession;
    Result<void> mayStart(const Job &job) const override;
    void post(JobCommand command) override;

    bool isOfThisRing() const;
    Result<void> checkLink(const Job &job) const;
    // An error the encoder shows may mean that it has lost its parameters.
    Refusal nameOf(const Message &fault) const;
    void takeFault(const Message &fault);
    void meetAgain();

    RingSession &m_bus;
    RingTraffic m_traffic;
    bool m_linkBoundsCycles;
};

} // namespace codewheel
