// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"

namespace codewheel {

class EncoderBus;

// The encoder that has replaced the one at a place, before its bus is told so: what can be seen of it is what
// the place shows, but nothing is known of it, neither values nor mode. For planning what is written to it;
// sends nothing.
class NewEncoder final : public EncoderSession
{
public:
    // The bus has an encoder at `place`, and must outlive this.
    NewEncoder(const EncoderBus &bus, Place place, DeviceDescription description);

    Place place() const override { return m_place; }
    const DeviceDescription &device() const override { return m_description; }
    const Capabilities &can() const override { return m_description.capabilities; }
    const Reading &latest() const override { return m_reading; }
    KindData valueOptions() const override;
    std::optional<Known> known(Parameter) const override { return std::nullopt; }
    std::optional<KnownCams> cams(unsigned) const override { return std::nullopt; }
    void tell(Parameter, const std::optional<Value> &) override {}
    Result<std::vector<Step>> planned(const std::vector<Job> &jobs) const override;
    Result<JobId> start(const Job &job, Pace pace) override; // always refused
    std::optional<JobId> runningJob() const override { return std::nullopt; }
    void proceed() override {}
    void cancel(OnCancel) override {}
    int eepromWrites() const override { return 0; }
    QDateTime dateTime(Instant at) const override;

private:
    const EncoderBus &m_bus;
    Place m_place;
    DeviceDescription m_description;
    Reading m_reading;
};

} // namespace codewheel
