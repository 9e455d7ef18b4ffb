// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/job_run.h"
#include "kinds/interbus/words/word_answer.h"

#include <chrono>

namespace codewheel {

// A job of a cyclic encoder in progress: each step puts a word into OUT, which stays there until the encoder
// has answered it. A driver derives from it and says what its words mean.
template <typename OneStep>
class WordRun : public JobRun<OneStep>
{
    using Base = JobRun<OneStep>;

public:
    using Base::isDone;

    // Plans the steps from the state the encoder is in, or says why it must not be in it. Called by itself in
    // the first cycle if IN was not known before.
    Result<void> prepare(Word in, Word out)
    {
        m_isPrepared = true;
        return plan(in, out);
    }

    // `in` came in while `out` was on the bus. Returns the word that goes out next.
    Word cycle(Word in, Word out, Instant now)
    {
        m_unseen.reset();
        watch(in, out);
        if (!m_isPrepared && !m_cancelled) // what was cancelled before it was planned is never planned
            if (auto prepared = prepare(in, out); !prepared)
                finish(std::move(prepared));
        while (!isDone()) {
            if (m_steps.atEnd()) {
                finish(resultAt(in));
            } else if (m_steps.begun) {
                if (takeAnswer(answerTo(in, out, now), in) == WordAnswer::waiting)
                    return m_steps.current().out;
            } else if (!mayBegin(in)) {
                return out;
            } else if (auto why = whyNotNow(in)) {
                fail(*std::move(why));
            } else {
                beginStep();
                begin(in, now);
                reportProgress(false);
                return m_steps.current().out;
            }
        }
        return out;
    }

    // `out` has gone out, and what came in meanwhile cannot be believed.
    void wait(Word out) { m_unseen = out; }

    // ALARM STOP, bus stopped, link lost.
    void stop(const Refusal &why)
    {
        InDoubt &inDoubt = m_account.outcome.inDoubt;
        if (endsOutOfSight(why)) {
            this->leaveOutOfSight();
            if (m_isPrepared)
                doubt(inDoubt, why.id != RefusalId::busStopped || hasGoneOut());
        } else if (m_isPrepared && mayStillAct(hasGoneOut())) {
            doubt(inDoubt, hasGoneOut());
            inDoubt.out.clear(); // 00000000 follows, or the word of somebody else stands there
        }
        if (m_reading.state == EncoderState::readOut) // which 00000000 ends
            this->leaveOutOfSight();
        finish(tl::unexpected(why));
    }

protected:
    using Base::ask;
    using Base::Base;
    using Base::beginStep;
    using Base::finish;
    using Base::goesByItself;
    using Base::m_account;
    using Base::m_cancelled;
    using Base::m_reading;
    using Base::m_steps;
    using Base::reportProgress;
    using Base::result;

    virtual Result<void> plan(Word in, Word out) = 0;
    // Sees every cycle first, whatever the step is.
    virtual void watch(Word in, Word out) = 0;
    // The current step has not begun. False: the user, or what is in IN, does not allow it yet.
    virtual bool mayBegin(Word /*in*/)
    {
        if (goesByItself())
            return true;
        ask();
        return false;
    }
    // Why the current step must not begin with this in IN.
    virtual std::optional<Refusal> whyNotNow(Word /*in*/) const { return std::nullopt; }
    virtual void begin(Word in, Instant now) = 0;
    // Nobody sees what becomes of the words that were sent: what they may have done. `nextMayBeSent`: so may
    // the one that goes out next; a bus that was stopped has not sent it.
    virtual void doubt(InDoubt &doubt, bool nextMayBeSent) = 0;
    // The word that is in OUT, or was sent without an answer that can be believed, stores or sets something,
    // and what becomes of it has not been seen.
    virtual bool mayStillAct(bool hasGoneOut) const = 0;

    virtual WordAnswer answerTo(Word in, Word out, Instant now) = 0;
    virtual void stepDone(Word in) = 0;
    // The encoder refused the current step, said nothing, or has restarted.
    virtual void stepFailed(WordAnswer how, Word in) = 0;
    virtual void fail(Refusal why) = 0;
    virtual Refusal refusalFor(Word in) const = 0;

    // All steps are done.
    virtual Result<void> resultAt(Word /*in*/)
    {
        if (auto ended = result(); !ended)
            return ended;
        return m_lastError && endsInError(m_lastErrorAt) ? tl::unexpected(*m_lastError) : Result<void>();
    }
    // Whether the user's words ended in an error that they had gone on after; it answered that step.
    virtual bool endsInError(std::size_t step) const = 0;

    Refusal noAnswer(Word in, Instant timeOut) const
    {
        return {RefusalKind::device,
                RefusalId::noAnswer,
                {std::chrono::duration<double>(timeOut).count(), m_steps.current().out, in}};
    }
    bool isPrepared() const { return m_isPrepared; }
    bool hasGoneOut() const { return m_steps.begun && !m_steps.atEnd() && hasGoneOut(m_steps.current().out); }
    bool hasGoneOut(Word out) const { return m_unseen == out; }

private:
    WordAnswer takeAnswer(WordAnswer answer, Word in)
    {
        if (answer == WordAnswer::done)
            stepDone(in);
        else if (answer == WordAnswer::error && goesOnAfterError())
            goOnAfterError(in);
        else if (answer != WordAnswer::waiting)
            stepFailed(answer, in);
        return answer;
    }

    bool goesOnAfterError() const
    {
        const auto *send = this->template job<SendWords>();
        return send != nullptr && send->afterError == SendWords::AfterError::goOn && !m_cancelled;
    }
    // The next word may be the way out of the error: run, once its cause is gone.
    void goOnAfterError(Word in)
    {
        m_lastError = refusalFor(in);
        m_lastErrorAt = m_steps.index;
        m_steps.goOn();
    }

    bool m_isPrepared = false;
    std::optional<Word> m_unseen; // the last word that went out while nothing came in that can be believed
    std::optional<Refusal> m_lastError; // that the words of the user went on after
    std::size_t m_lastErrorAt = 0;      // the step it answered
};

} // namespace codewheel
