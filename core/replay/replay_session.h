// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "replay/recorded_encoder.h"
#include "vocabulary/encoder_session.h"

#include <map>

namespace codewheel {

class ReplayBus;

// An encoder of a recording, as views see it: what it showed at the moment shown, and what was known of it
// then. Whatever would send something is refused.
class ReplayEncoderSession final : public EncoderSession
{
    Q_OBJECT

public:
    ReplayEncoderSession(const ReplayBus &bus, Place place, DeviceDescription device);

    Place place() const override { return m_place; }
    const DeviceDescription &device() const override { return m_device; }
    const Capabilities &can() const override { return m_can; }
    const Reading &latest() const override { return m_reading; }
    std::optional<Known> known(Parameter parameter) const override;
    std::optional<KnownCams> cams(unsigned) const override { return {}; }       // not recorded
    void tell(Parameter parameter, const std::optional<Value> &value) override; // so that it can be shown

    Result<std::vector<Step>> planned(const std::vector<Job> &jobs) const override;
    Result<JobId> start(const Job &job, Pace pace) override;
    std::optional<JobId> runningJob() const override { return {}; }
    void proceed() override {}
    void cancel(OnCancel) override {}
    int eepromWrites() const override { return 0; }
    QDateTime dateTime(Instant at) const override;

    // By its bus.
    void show(const RecordedEncoder::Moment &moment, Instant at, const RecordedEncoder::Described &described);

private:
    Reading readingOf(const RecordedEncoder::Moment &moment, Instant at) const;
    Reading ofWords(Word in, Word out, Instant at) const;
    std::vector<Known> allKnown() const;

    const ReplayBus &m_bus;
    const Place m_place;
    const DeviceDescription m_device;
    const Capabilities m_can;
    Reading m_reading;
    ParameterValues m_known;
    std::map<Parameter, Value> m_told; // by the user, who looks at it now
    Instant m_knownSince{};
};

} // namespace codewheel
