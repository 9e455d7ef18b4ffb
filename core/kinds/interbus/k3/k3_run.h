// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/k3/k3_cam_run.h"
#include "kinds/interbus/k3/k3_encoder.h"
#include "kinds/interbus/k3/k3_handshake.h"
#include "kinds/interbus/k3/k3_late_answer.h"
#include "kinds/interbus/words/word_run.h"

namespace codewheel {

// A job of a K3 encoder in progress: one word after the other (K3Handshake), and what each answer means. What
// is read shortens the rest (refine()), K3CamRun keeps what is about cams, k3Refusal() names an error, and
// what was under way when the job was cancelled is a K3LateAnswer, whether a preset was carried out says
// K3PresetProof. Used by K3Driver.
class K3Run final : public WordRun<K3Step>
{
public:
    // The job has been checked. The encoder must outlive this.
    K3Run(JobId id, const Job &job, Pace pace, K3Encoder &encoder);
    ~K3Run() override { (void)m_encoder.knowledge.endJob(); }
    Q_DISABLE_COPY_MOVE(K3Run)

private:
    // What the encoder has confirmed since the last run.
    struct Confirmed
    {
        ParameterValues values;
        bool reset = false; // to default
    };

    Result<void> plan(Word in, Word out) override;
    Job whatIsDone(Word in) const;
    void watch(Word in, Word out) override;
    bool mayBegin(Word in) override;
    std::optional<Refusal> whyNotNow(Word in) const override;
    void begin(Word in, Instant now) override;
    void doubt(InDoubt &doubt, bool nextMayBeSent) override;
    bool mayStillAct(bool hasGoneOut) const override;
    WordAnswer answerTo(Word in, Word out, Instant now) override;
    void stepDone(Word in) override;
    void stepFailed(WordAnswer how, Word in) override;
    void fail(Refusal why) override;
    Refusal refusalFor(Word in) const override;
    Refusal whyNoAnswer(const K3Step &step, Word in);
    bool mayBeInCamMode() const;
    Result<void> resultAt(Word in) override;
    bool endsInError(std::size_t step) const override;
    void complete(Outcome &outcome) override;
    LeftMode modeNow() const { return {m_encoder.knowledge.mode(), m_encoder.knowledge.camProgram()}; }
    std::optional<LeftMode> modeLeft() const; // empty: as before, or as it was to be
    bool follows(StepKind kind) const;
    void lastOneCycle();
    bool isHeldBack(Word in, Instant now) const;

    // What a preset has done (k3_run_preset.cpp).
    bool showsPreset() const;
    bool presetIsOpen(Word in, Instant now) const;
    void judgePreset(Word in);
    void noteNotSet(RefusalCode why, std::vector<RefusalArgument> arguments, Word in);
    void noteMayBeSpeed(Word in);
    void presetFlagRead(std::int64_t flag);
    void presetWasNotTaken();
    void readPresetAgain();

    // What the answer to a step means.
    void ran();
    void outIsCleared(Word in);
    void wordDone(const K3Step &step);
    void readDone(const K3Step &step, Word in);
    void readAgain(const K3Step &step);
    void verify(const K3Step &step, std::int64_t value);
    void camReadOutEnded(const K3Step &step);
    void runBeforeTheRest();
    void answeredByError(Word in);

    // How a job ends early.
    void leaveOffAt(Instant now) override;
    bool hasTaken() const override;
    bool canRestore() const override;
    bool isPositionStep(const K3Step &step) const override;
    const ParameterValues &confirmed() const override { return m_confirmed.values; }
    bool mayLeftOffAct(bool nextMayBeSent) const;
    void doubtStep(InDoubt &doubt, const K3Step &step);
    void doubtCams(InDoubt &doubt) const;
    void lookForRestart(Word in);
    void lookForLateAnswer(Word in);
    void dropConfirmed();
    K3Steps stepsOfCancel(Word in);
    K3Steps stepsToRestore(bool parameterizing);
    K3Steps stepsToRestore(const ParameterValues &taken, bool parameterizing) const;

    K3Encoder &m_encoder;
    K3Handshake m_handshake;
    K3CamRun m_cams;
    Job m_whatIsDone; // the job, as the encoder was when it began
    Confirmed m_confirmed;
    ParameterValues m_unproven; // run was answered by 00000000h, and they were not read back yet
    std::optional<K3LateAnswer> m_late;
    std::optional<K3Step> m_leftOff;   // by a cancel; its word may still act
    std::optional<Word> m_goesOut;     // that word, in the next exchange
    std::optional<Refusal> m_mismatch; // found when reading back, which goes on
    LeftMode m_modeBefore;
    std::optional<Refusal> m_notSet; // the position, or it is not known whether it was; the rest goes on
    // What was shown before and after a preset as positions, until it is certain that they are no speeds.
    struct Shown
    {
        std::optional<std::int64_t> before;
        std::optional<std::int64_t> after;
    };
    std::optional<Shown> m_mayBeSpeed;
    bool m_wasArmed = false;   // the preset, when its word was put into OUT
    bool m_mayBeInRpm = false; // what IN showed then: position mode was only told
    Word m_inWhenAsked = 0;
    bool m_foundParameterizing = false; // the encoder was in a parameterization before the job
    int m_readAgain = 0;                // of the value that is read: answers that may be torn
    bool m_foundInError = false;        // so was it in the error state
    bool m_ranAtZero = false;           // run was answered so
    bool m_resetIsSent = false;         // to default, and not run
    bool m_maySwitchMode = false;       // a word that does, or may do so in the mode it is in, was sent
};

} // namespace codewheel
