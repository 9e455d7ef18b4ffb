// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/driven_encoder_session.h"

namespace codewheel {

class EncoderBus;

// An encoder of a connected bus: its clock is that of the bus, and its messages are among those of the bus.
class EncoderOnBus : public DrivenEncoderSession
{
public:
    EncoderOnBus(EncoderBus &bus, std::size_t device, Place place, const DeviceDescription &description);

    QDateTime dateTime(Instant at) const override;
    Result<std::vector<Step>> planned(const std::vector<Job> &jobs) const override;

protected:
    void report(Message message, Instant at) override;
    Instant now() const override;
    Instant instantOf(const QDateTime &time) const override;

private:
    EncoderBus &m_ofBus;
};

} // namespace codewheel
