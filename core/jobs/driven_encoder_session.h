// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "jobs/job_command.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/message.h"

#include <map>

namespace codewheel {

// What every encoder session with a driver behind it has in common, whatever the bus: it keeps what is known
// of the encoder, the running job and the count of EEPROM writes, and turns the driver's events into signals.
// The bus it is on carries its requests to the driver.
class DrivenEncoderSession : public EncoderSession
{
    Q_OBJECT

public:
    // `device` is its index in the runner of the bus. `description` must outlive the session.
    DrivenEncoderSession(std::size_t device, Place place, const DeviceDescription &description);

    Place place() const override { return m_place; }
    const DeviceDescription &device() const override { return m_description; }
    const Capabilities &can() const override { return m_can; }

    const Reading &latest() const override { return m_reading; }
    std::optional<Instant> unchangedSince() const override { return m_unchangedSince; }
    std::optional<Known> known(Parameter parameter) const override;
    std::optional<KnownCams> cams(unsigned program) const override;
    QString takenWithoutRun() const override;
    bool hasTakenCams() const override;
    std::optional<LeftMode> leftInMode() const override { return m_leftInMode; }
    QString version() const override { return m_version; }
    void tell(Parameter parameter, const std::optional<Value> &value) override;

    Result<JobId> start(const Job &job, Pace pace) override;
    std::optional<JobId> runningJob() const override { return m_runningJob; }
    void proceed() override;
    void cancel(OnCancel how) override;

    int eepromWrites() const override { return m_eepromWrites; }
    void countEepromWrites(int writes) { m_eepromWrites += writes; }

    // Of what a job was about to write when nobody saw the encoder any more: what is not known yet, and can
    // be read.
    std::vector<Parameter> readableDoubts() const;

    void show(const Reading &reading, const Freshness::Circumstances &bus);
    void take(const Event &event, Instant at);

protected:
    // Whether the bus allows the job now.
    virtual Result<void> mayStart(const Job &job) const = 0;
    virtual void post(JobCommand command) = 0;
    // Message without time and place.
    virtual void report(Message message, Instant at) = 0;
    virtual Instant now() const = 0;
    virtual Instant instantOf(const QDateTime &time) const = 0;

    void limitTo(const Capabilities &can) { m_can = can; }
    void moveTo(Place place) { m_place = place; }
    std::size_t index() const { return m_index; } // in the runner
    void moveIndexTo(std::size_t index) { m_index = index; }
    bool knowsAnything() const { return !m_known.empty(); }
    bool knowsValues() const; // besides which encoder it is
    // What it had; not what tells which encoder it is.
    void forgetValues();
    // It has started anew: what it had in force is in force again only if it was stored.
    void forgetWhatWasNotStored();
    // It was out of sight, and may be another encoder by now. What was known before stays so.
    void forgetKnown();

private:
    void takeOver(const KnownBefore &before) override;
    Known withKept(Known known) const;
    void take(const Outcome &outcome, Instant at);
    void take(const KnowledgeChanged &change);
    void compareWithBefore();
    void take(const InDoubt &doubt, Instant at);
    void takeModeLeft(const Outcome &outcome, Instant at);
    void takeWhatWaitsForRun(const Outcome &outcome, Instant at);
    void noteTaken(const ParameterValues &values, bool reset, Instant at);
    void postAllKnown();

    std::size_t m_index;
    Place m_place;
    const DeviceDescription &m_description;
    Capabilities m_can;
    Reading m_reading;
    std::optional<Instant> m_unchangedSince;
    QString m_version;
    std::map<Parameter, Known> m_known;
    std::map<unsigned, KnownCams> m_cams; // by program number
    JobId m_lastJob = 0;
    std::optional<JobId> m_runningJob;
    Job m_job;
    InDoubt m_inDoubt; // of the last job that ended out of sight, or of words by hand
    InDoubt m_taken;   // by the encoder, confirmed or perhaps, and not run
    Instant m_takenAt{};
    std::optional<LeftMode> m_leftInMode;
    Instant m_leftAt{};
    int m_eepromWrites = 0;
};

} // namespace codewheel
