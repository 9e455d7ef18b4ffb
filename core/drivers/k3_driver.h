// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/cyclic_driver.h"
#include "drivers/job_run.h"
#include "drivers/k3_cam_record.h"
#include "drivers/k3_handshake.h"
#include "drivers/k3_knowledge.h"
#include "drivers/k3_plan.h"
#include "drivers/k3_reading.h"

#include <optional>

namespace codewheel {

// Drives a K3 encoder of any make, as its description says: plans the steps of a job, carries them out one by
// one, refines the plan by what it reads, and ends in a state that it can name.
class K3Driver final : public CyclicDriver
{
public:
    // The description must outlive the driver.
    explicit K3Driver(const DeviceDescription &device, K3Timing timing = {});

    const Reading &reading() const override { return m_reading; }
    bool busy() const override { return m_run.has_value(); }
    void setKnown(const std::vector<Known> &known) override;
    Result<void> begin(JobId id, const Job &job, Pace pace, Word in, Word out, Instant now) override;
    void proceed() override;
    void cancel(OnCancel how, Instant now) override;
    void stop(RefusalId why, Instant now) override;
    Word cycle(Word in, Word out, Instant now) override;
    bool mayStand(Word out) const override { return !m_knowledge.isManufacturerPreset(out); }
    std::vector<Event> takeEvents() override;

private:
    struct Run : JobRun
    {
        using JobRun::JobRun;

        bool foundParameterizing = false; // the encoder was in a parameterization before the job
        K3Steps steps;
        Word inWhenAsked = 0;
        Instant cancelledAt{};
        std::optional<K3Step> inFlight;   // cancelled before it was confirmed; it may be taken yet
        ParameterValues confirmed;        // since the last run
        bool resetConfirmed = false;      // likewise
        bool ranAtZero = false;           // 00000000h answered run
        std::optional<Refusal> mismatch;  // of the read-back, which goes on
        std::optional<Refusal> lastError; // that the words of the user went on after
        std::size_t lastErrorAt = 0;      // the step it answered
        K3CamRecord cams;
    };

    Result<void> checkMode(const Job &job) const;
    Result<void> checkState(const Job &job, Word in) const;
    Result<void> prepare(Word in, Word out);
    void lookForRestart(Word in);
    void lookForLateAnswer(Word in);
    bool isStillProcessing(Word in, Instant now) const;
    Word carryOn(Word in, Word out, Instant now);
    bool mayBeginStep(Word in);
    bool followsManufacturerPreset() const;
    void beginStep(Word in, Instant now);
    void stepDone(Word in);
    void readDone(const K3Step &step, Word in);
    void verify(const K3Step &step, std::int64_t value);
    void leaveOut(Parameter parameter, std::int64_t value);
    void refine(Parameter parameter, std::int64_t value);
    void camReadOutDone(const K3Step &step, Word in);
    void camReadOutEnded(const K3Step &step);
    void planWrite(const CamProgram &now);
    void camWordTaken(Word out);
    void dropCams();
    Result<void> checkCams(Word in);
    K3Steps stepsToRestore(bool parameterizing);
    K3Steps stepsToRestoreCams() const;
    bool onlyAsksForCams() const;
    bool bringsBack(Word in) const;
    void fail(Refusal why);
    void failAt(Word in);
    bool goesOnAfterError() const;
    void goOnAfterError(Word in);
    bool endsInError() const;
    void finish(Result<void> result);
    static bool hasRestored(const Run &run);
    Evidence evidenceOf(const ParameterValues &written) const;
    void appendCancelSteps(Word in);
    void ranWithWhatWasConfirmed();
    void reportProgress(bool waits);
    bool canRestore() const;
    bool hasTaken() const;
    ParameterValues valuesToRestore() const;
    Refusal refusalFor(Word in) const;
    std::optional<Refusal> camRefusalFor(Word in) const;
    Refusal noAnswer(Word in) const;
    static Refusal restarted(Word in);
    static Refusal noValidPosition();
    std::vector<RefusalArgument> suspects() const;
    const K3Step &current() const { return m_run->steps[m_run->index]; }
    void flushKnowledge();

    const DeviceDescription &m_device;
    K3Timing m_timing;
    K3Knowledge m_knowledge;
    K3Plan m_plan;
    K3Handshake m_handshake;
    K3View m_view;
    Reading m_reading;
    std::optional<Run> m_run;
    std::vector<Event> m_events;
};

} // namespace codewheel
