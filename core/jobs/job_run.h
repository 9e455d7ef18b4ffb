// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/job_account.h"
#include "jobs/job_steps.h"
#include "vocabulary/reading.h"

#include <algorithm>
#include <span>
#include <utility>

namespace codewheel {

// The life of a job, whatever the encoder: accepted, step after step, waiting for the user, cancelled,
// restored, ended, with the account of what it read and wrote. A driver derives the run of its jobs from it
// and adds what its steps are, how they are sent, and what their answers mean.
template <typename OneStep>
class JobRun
{
public:
    virtual ~JobRun() = default;

    bool isDone() const { return m_isDone; }                 // the outcome is among the events
    bool waits() const { return m_hasAsked && !m_mayBegin; } // for the user: Pace::byHand
    void proceed() { m_mayBegin = m_hasAsked; }

    // A job that has already failed ends by itself.
    void cancel(OnCancel how, Instant now)
    {
        if (m_isDone || m_cancelled || m_failure)
            return;
        if (how == OnCancel::ifNothingTaken && hasTaken()) {
            reportProgress(waits());
            return;
        }
        m_cancelled = how;
        leaveOffAt(now);
    }

protected:
    // `known`, `reading` and `events` are the encoder's, which outlives the job: what it is known to have,
    // what it shows, where its events go.
    JobRun(JobId id, Job job, Pace pace, const KnownValues &known, const Reading &reading,
           std::vector<Event> &events)
        : m_job(std::move(job))
        , m_account(id, m_job, known)
        , m_reading(reading)
        , m_pace(pace)
        , m_known(known)
        , m_events(events)
    {}

    // The encoder has taken something, or may have.
    virtual bool hasTaken() const = 0;
    // What it has taken, as reported by Progress::confirmed; and whether that can be undone.
    virtual const ParameterValues &confirmed() const { return m_account.outcome.written; }
    virtual bool canRestore() const { return m_account.knowsBefore(m_account.outcome.written); }
    // The step gives the encoder a new position.
    virtual bool isPositionStep(const OneStep &step) const = 0;
    // The job was cancelled: its remaining steps are those that leave nothing half done.
    virtual void leaveOffAt(Instant now) = 0;
    // Adds to the outcome what only the driver knows.
    virtual void complete(Outcome &outcome) = 0;

    template <typename OneJob>
    const OneJob *job() const
    {
        return std::get_if<OneJob>(&m_job);
    }

    // By hand, a step waits for proceed(). What follows a failure or a cancel does not wait.
    bool goesByItself() const { return m_pace == Pace::byItself || m_failure || m_cancelled || m_mayBegin; }
    // Reports that the current step waits for the user. False: already reported.
    bool ask()
    {
        if (std::exchange(m_hasAsked, true))
            return false;
        reportProgress(true);
        return true;
    }
    void beginStep()
    {
        m_steps.begun = true;
        m_mayBegin = m_hasAsked = false;
    }

    // The first failure is reported; the remaining steps are dropped. True: it was the first.
    bool noteFailure(Refusal why)
    {
        m_steps.dropRest();
        if (m_failure)
            return false;
        m_failure = std::move(why);
        return true;
    }

    // True, once: the job was cancelled, and what still had to be done then is done. What the user chose
    // comes next.
    bool hasLeftOffNow() { return m_cancelled && m_steps.atEnd() && !std::exchange(m_hasLeftOff, true); }
    bool leavesOff() const { return m_cancelled && !m_hasLeftOff; } // cancelled, and not done with that
    bool isAnyPositionStep(std::span<const OneStep> steps) const
    {
        return std::ranges::any_of(steps, [this](const OneStep &step) { return isPositionStep(step); });
    }
    // Whether a new position was sent, carried out or not. By the previous values the encoder would then show
    // neither the position of before nor the one that was set.
    bool hasSentPosition() const
    {
        return m_account.outcome.inDoubt.position || isAnyPositionStep(m_steps.sent());
    }
    bool mayRestore() const { return canRestore() && !hasSentPosition(); }
    // What was written is undone if that was asked for and the previous values are known.
    bool givesBack() const
    {
        return m_cancelled == OnCancel::restorePrevious && !m_account.outcome.written.empty() && mayRestore();
    }
    // All previous values have been restored.
    bool hasRestored() const { return m_restores && m_steps.atEnd() && !m_failure; }

    Result<void> result() const
    {
        if (m_failure)
            return tl::unexpected(*m_failure);
        if (m_cancelled)
            return refuse(RefusalKind::stopped, RefusalId::cancelled);
        return {};
    }
    void finish(Result<void> result)
    {
        m_isDone = true;
        Outcome &outcome = m_account.outcome;
        outcome.result = std::move(result);
        outcome.leftIn = m_isOutOfSight ? EncoderState::unknown : m_reading.state;
        const bool hasPositionStep = isAnyPositionStep(m_steps.done());
        outcome.isPositionSet = m_cancelled && !m_failure && hasPositionStep;
        const bool isSeen = outcome.positionAfter || outcome.isPositionSet;
        // Accepted, and nobody saw what came of it.
        if (hasPositionStep && !isSeen && endedOutOfSight(outcome))
            outcome.inDoubt.position = true;
        complete(outcome);
        outcome.eepromWrites += m_known.eepromWrites() - m_account.writesBefore;
        m_events.emplace_back(outcome);
    }

    // Its state when the job ends is not known.
    void leaveOutOfSight() { m_isOutOfSight = true; }

    void reportProgress(bool waitsForUser)
    {
        m_events.emplace_back(Progress{.job = m_account.outcome.job,
                                       .index = static_cast<int>(m_steps.index),
                                       .steps = {m_steps.all.begin(), m_steps.all.end()},
                                       .waitsForUser = waitsForUser,
                                       .confirmed = confirmed(),
                                       .canRestore = mayRestore(),
                                       .setsPosition = hasSentPosition(),
                                       .hasTaken = hasTaken()});
    }

    const Job m_job;
    JobAccount m_account;
    JobSteps<OneStep> m_steps;
    std::optional<Refusal> m_failure; // set: the remaining steps only leave the encoder in good order
    std::optional<OnCancel> m_cancelled;
    bool m_restores = false; // the last steps restore the previous values
    const Reading &m_reading;

private:
    Pace m_pace;
    const KnownValues &m_known;
    std::vector<Event> &m_events;
    bool m_hasAsked = false; // by hand: the user was told that the current step waits
    bool m_mayBegin = false; // and has said that it may begin
    bool m_hasLeftOff = false;
    bool m_isOutOfSight = false;
    bool m_isDone = false;
};

} // namespace codewheel
