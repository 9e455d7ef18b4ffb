// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/driven_encoder_session.h"

namespace codewheel {

class CanopenSession;

// An encoder on CANopen, as views see it: turns jobs into commands for the runner, and what CanopenSession
// pumps out of the thread of the bus into signals.
class CanopenEncoderSession final : public DrivenEncoderSession
{
    Q_OBJECT

public:
    CanopenEncoderSession(CanopenSession &bus, std::size_t device, int node,
                          const DeviceDescription &description);

    QDateTime dateTime(Instant at) const override;
    Result<std::vector<Step>> planned(const std::vector<Job> &jobs) const override;

private:
    Result<void> mayStart(const Job &job) const override;
    void post(JobCommand command) override;
    void report(Message message, Instant at) override;
    Instant now() const override;
    Instant instantOf(const QDateTime &time) const override;

    CanopenSession &m_bus;
};

} // namespace codewheel
