// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/cyclic_driver.h"
#include "drivers/job_run.h"
#include "drivers/la66_handshake.h"
#include "drivers/la66_knowledge.h"
#include "drivers/la66_plan.h"

#include <optional>

namespace codewheel {

// Drives a TR LA-66: turns a job into services, carries them out step by step, and leaves OUT at 0 in normal
// mode. Service bit and data never change in one cycle, whatever happens to the job.
class La66Driver final : public CyclicDriver
{
public:
    // The description must outlive the driver.
    explicit La66Driver(const DeviceDescription &device, La66Timing timing = {});

    const Reading &reading() const override { return m_reading; }
    bool busy() const override { return m_run.has_value(); }
    void setKnown(const std::vector<Known> &known) override { m_knowledge.values().set(known); }
    Result<void> begin(JobId id, const Job &job, Pace pace, Word in, Word out, Instant now) override;
    void proceed() override;
    void cancel(OnCancel how, Instant now) override;
    void stop(RefusalId why, Instant now) override;
    Word cycle(Word in, Word out, Instant now) override;
    std::vector<Event> takeEvents() override;

private:
    struct Run : JobRun
    {
        using JobRun::JobRun;

        La66Steps steps;
        std::optional<Refusal> lastError; // that the words of the user went on after
        std::size_t lastErrorAt = 0;      // the step it answered
    };

    void prepare(Word in, Word out);
    Word carryOn(Word in, Word out, Instant now);
    bool mayBeginStep(Word in);
    bool setsPosition() const;
    void beginStep(Instant now);
    void stepDone(Word in, Word out);
    void serviceDone(const La66Step &step, Word in, Word out);
    void readDone(const La66Step &step, std::int64_t value, Word out);
    void leaveOut(Parameter parameter);
    void fail(Refusal why, Word out);
    bool goesOnAfterError() const;
    void goOnAfterError(Word in);
    void finish(Result<void> result);
    Result<void> result() const;
    void appendRestore();
    bool canRestore() const;
    bool hasTaken() const;
    void reportProgress(bool waits);
    void flushKnowledge();
    Refusal refused(Word in) const;
    Refusal noAnswer(Word in) const;
    const La66Step &current() const { return m_run->steps[m_run->index]; }

    La66Timing m_timing;
    La66Knowledge m_knowledge;
    La66Plan m_plan;
    La66Handshake m_handshake;
    Reading m_reading;
    Word m_out = 0; // as it stood on the bus in the last cycle, or goes there in the next
    std::optional<Run> m_run;
    std::vector<Event> m_events;
};

} // namespace codewheel
