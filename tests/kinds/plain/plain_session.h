// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/encoder_on_bus.h"

namespace codewheel::test {

class PlainBus;

// An encoder of the tests' own kind, as views see it.
class PlainSession final : public EncoderOnBus
{
public:
    PlainSession(PlainBus &bus, std::size_t index, Place place, const DeviceDescription &device);

    bool showsPosition() const override { return latest().position.has_value(); } // in every state
    using DrivenEncoderSession::forgetValues;
    using DrivenEncoderSession::forgetWhatWasNotStored;

private:
    Result<void> mayStart(const Job &job) const override;
    void post(JobCommand command) override;

    PlainBus &m_bus;
};

} // namespace codewheel::test
