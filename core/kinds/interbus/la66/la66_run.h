// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/la66/la66_encoder.h"
#include "kinds/interbus/la66/la66_handshake.h"
#include "kinds/interbus/words/word_run.h"

namespace codewheel {

// A job of an LA-66 in progress: its services one after the other. Used by La66Driver.
class La66Run final : public WordRun<La66Step>
{
public:
    // The job has been checked. The encoder must outlive this.
    La66Run(JobId id, const Job &job, Pace pace, La66Encoder &encoder);

private:
    Result<void> plan(Word in, Word out) override;
    void watch(Word /*in*/, Word out) override { m_out = m_sent = out; }
    bool mayBegin(Word in) override;
    std::optional<Refusal> whyNotNow(Word in) const override;
    void begin(Word in, Instant now) override;
    void doubt(InDoubt &doubt, bool nextMayBeSent) override;
    bool mayStillAct(bool hasGoneOut) const override { return isWriting(hasGoneOut); }
    bool isWriting(bool nextMayBeSent) const;
    WordAnswer answerTo(Word in, Word out, Instant now) override { return m_handshake.cycle(in, out, now); }
    void stepDone(Word in) override;
    void stepFailed(WordAnswer how, Word in) override;
    void fail(Refusal why) override;
    Refusal refusalFor(Word in) const override;
    bool endsInError(std::size_t step) const override;
    bool hasTaken() const override;
    void leaveOffAt(Instant now) override;
    void complete(Outcome &outcome) override;

    bool receivesPosition() const;
    bool isPositionStep(const La66Step &step) const override;
    void serviceDone(const La66Step &step, Word in);
    void readDone(const La66Step &step, std::int64_t value);
    void leaveOut(Parameter parameter);
    void giveBack();

    La66Encoder &m_encoder;
    La66Handshake m_handshake;
    Word m_out = 0;  // as it was on the bus in the last cycle, or goes there in the next
    Word m_sent = 0; // as it was on the bus in the last cycle
};

} // namespace codewheel
