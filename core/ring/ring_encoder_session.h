// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/encoder_session.h"
#include "encoder/message.h"

#include <map>

namespace codewheel {

class BusSession;

// An encoder of a ring, as views see it: turns jobs into commands for the runner, and what BusSession pumps
// out of the bus thread into signals. Keeps what is known of the encoder, by evidence.
class RingEncoderSession final : public EncoderSession
{
    Q_OBJECT

public:
    // `description` must outlive the session. `linkBoundsCycles`: a word can be sent for one bus cycle only.
    RingEncoderSession(BusSession &bus, std::size_t device, DeviceNumber number,
                       const DeviceDescription &description, bool linkBoundsCycles);

    DeviceNumber number() const override { return m_number; }
    const DeviceDescription &device() const override { return m_description; }
    // What its description says, as far as the link allows.
    const Capabilities &can() const override { return m_can; }

    const Reading &latest() const override { return m_reading; }
    std::optional<Known> known(Parameter parameter) const override;
    std::optional<KnownCams> cams(unsigned program) const override;
    void tell(Parameter parameter, std::optional<std::int64_t> value) override;

    Result<JobId> start(const Job &job, Pace pace) override;
    std::optional<JobId> runningJob() const override { return m_runningJob; }
    void proceed() override;
    void cancel(OnCancel how) override;

    int eepromWrites() const override { return m_eepromWrites; }
    QDateTime dateTime(Instant at) const override;

private:
    friend class BusSession;
    void show(const Reading &reading);
    void take(const Event &event, Instant at);
    void take(const Outcome &outcome, Instant at);
    void take(const KnowledgeChanged &change);
    // An error the encoder shows may say that it has lost its parameters.
    Refusal nameOf(const Message &fault) const;
    void takeFault(const Message &fault);
    void report(Message message, Instant at);
    void postKnown();
    void moveTo(std::size_t device) { m_place = device; } // the ring is another
    void countEepromWrites(int writes) { m_eepromWrites += writes; }
    Result<void> checkLink(const Job &job) const;

    BusSession &m_bus;
    std::size_t m_place; // in the ring
    DeviceNumber m_number;
    const DeviceDescription &m_description;
    bool m_linkBoundsCycles;
    Capabilities m_can;
    Reading m_reading;
    std::map<Parameter, Known> m_known;
    std::map<unsigned, KnownCams> m_cams; // by program
    JobId m_lastJob = 0;
    std::optional<JobId> m_runningJob;
    Job m_job;
    int m_eepromWrites = 0;
};

} // namespace codewheel
