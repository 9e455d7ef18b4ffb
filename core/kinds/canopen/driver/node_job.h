// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/job_run.h"
#include "kinds/canopen/driver/node_encoder.h"

#include <span>

namespace codewheel::canopen {

// It writes something, stores or restores.
bool changesEncoder(const Job &job);

// A job of an encoder on CANopen in progress: its requests one after the other, and what their answers mean.
// Nothing is written twice: after a write without an answer the object is read, and the outcome says whether
// it was done. Used by the driver, which sends what the job wants.
class NodeJob final : public JobRun<NodeStep>
{
public:
    // The job has been checked (NodePlan). The encoder must outlive this. `mayStop`: the node may be stopped
    // for what it takes only then, and is started again.
    NodeJob(JobId id, Job job, Pace pace, bool mayStop, NodeEncoder &encoder);

    // The next request; empty while it waits for the user or for the node, and when it is done.
    std::optional<NodeRequest> next(Instant now);
    void answered(const SdoOutcome &outcome, Instant now);
    // When it will not wait for the node any longer; empty: it does not wait for it.
    std::optional<Instant> waitsUntil() const;
    void stop(const Refusal &why);
    bool changesEncoder() const { return canopen::changesEncoder(m_job); }
    // It stores or restores, or the node was reset.
    bool mayBeSilent() const;
    // Seen on the bus.
    void nodeHasBooted();

private:
    using Task = NodeStep::Task;
    using Answer = SdoOutcome::Kind;

    // node_job.cpp
    void settle();
    void leaveOutWhatIsThere();
    void leaveOutCamsThatAreThere();
    bool mayBeLost(const ParameterValue &value) const;
    bool waitsForNode() const;
    bool isBackAfterReset(Instant now);
    bool isStarted(Instant now);
    void begin(Instant now);
    NodeRequest requestOf(const NodeStep &step) const;
    std::vector<std::uint8_t> bitsOf(const NodeStep &step) const;
    void complete(Outcome &outcome) override;

    // node_job_answers.cpp
    void readAnswered(const SdoOutcome &outcome, Instant now);
    void notRead(const SdoOutcome &outcome);
    void noteRead(const NodeStep &step);
    void notePosition(const NodeStep &step);
    void checkVendor(const SdoOutcome &outcome);
    void fail(Refusal why);
    void failUnsent(Refusal why); // so the step was not carried out
    Refusal refusalOf(const SdoOutcome &outcome) const;

    // node_job_writes.cpp
    void writeAnswered(const SdoOutcome &outcome, Instant now);
    void accepted(Instant now);
    void stored();
    void presetAccepted();
    void camAccepted(Instant now);
    void aborted(const SdoOutcome &outcome);
    bool stopsForIt(const SdoOutcome &outcome);
    void notAnswered();
    void readBack(const SdoOutcome &outcome, Instant now);
    void judgePreset();
    void checkPreset();
    void endAtRestart();
    void failAsUnknown();

    // node_job_cancel.cpp
    bool hasTaken() const override;
    bool canRestore() const override;
    bool isPositionStep(const NodeStep &step) const override { return step.task == Task::preset; }
    void leaveOffAt(Instant now) override;
    void goOnAfterCancel();
    void noteDoubt(const NodeStep &step, InDoubt &doubt) const;
    void doubtDone(std::span<const NodeStep> steps);

    NodeEncoder &m_encoder;
    const bool m_mayStop;
    bool m_isUnderWay = false;            // the request of the step
    bool m_hasBooted = false;             // the node, though nothing in the job asked for it
    bool m_isCompared = false;            // what is there already was left out
    bool m_startsAgain = false;           // the node was operational
    bool m_hasStopped = false;            // it, for a write that it refused while it ran
    Instant m_begunAt{};                  // the step
    Value m_whole = 0;                    // of the object whose bits are written
    std::optional<NodeStep> m_unanswered; // the write whose outcome is not known yet
    std::optional<Refusal> m_missing;     // an object that the encoder does not have
    std::optional<std::int64_t> m_presetBefore;
    CamProgram m_camsRead{};
    std::optional<CamProgram> m_camsGiven; // what the encoder has after the writes so far
    ParameterValues m_toStore;             // in force, found by reading
};

// A step that changes what the encoder has.
bool changesSomething(const NodeStep &step);

} // namespace codewheel::canopen
