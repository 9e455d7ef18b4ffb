// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/driven_encoder_session.h"

namespace codewheel::test {

class PlainBus;

// An encoder of the tests' own kind, as views see it.
class PlainSession final : public DrivenEncoderSession
{
public:
    PlainSession(PlainBus &bus, std::size_t index, Place place, const DeviceDescription &device)
        : DrivenEncoderSession(index, place, device)
        , m_bus(bus)
    {}

    bool showsPosition() const override { return latest().position.has_value(); } // in every state
    QDateTime dateTime(Instant at) const override;
    Result<std::vector<Step>> planned(const std::vector<Job> &jobs) const override;
    using DrivenEncoderSession::forgetValues;
    using DrivenEncoderSession::forgetWhatWasNotStored;

private:
    Result<void> mayStart(const Job &job) const override;
    void post(JobCommand command) override;
    void report(Message message, Instant at) override;
    Instant now() const override;
    Instant instantOf(const QDateTime &time) const override;

    PlainBus &m_bus;
};

} // namespace codewheel::test
