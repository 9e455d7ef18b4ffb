// SPDX-License-Identifier: GPL-3.0-or-later
// How a job ends before its end: by the user, by a restart of the encoder, by what comes late.
#include "kinds/interbus/k3/k3_run.h"
#include "kinds/interbus/words/k3_cam_fields.h"
#include "kinds/interbus/words/word_refusals.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

bool mayBeTaken(const K3Step &step)
{
    return step.kind == StepKind::parameter || step.kind == StepKind::camParameter ||
           (step.kind == StepKind::word &&
            (k3::isParameterWord(step.out) || (step.inCamMode && fieldSetBy(step.out))));
}

bool resetsToDefault(const Job &job)
{
    const auto *send = std::get_if<SendWords>(&job);
    return std::holds_alternative<ResetToDefault>(job) || (send && std::ranges::any_of(send->words, isReset));
}

} // namespace

// OUT goes back to 0. Run cannot be taken back: its answer is awaited.
void K3Run::leaveOffAt(Instant now)
{
    const bool begun = m_steps.begun;
    const auto value = begun ? valueGivenBy(m_steps.current()) : std::nullopt;
    if (value && m_handshake.hasConfirmed())
        replaceValue(m_confirmed.values, *value);
    else if (value || (begun && m_steps.current().kind == StepKind::camParameter))
        m_late.emplace(m_steps.current(), now);
    if (begun && isPositionStep(m_steps.current()))
        m_account.outcome.inDoubt.position = true;
    const bool runIsOnItsWay = begun && m_steps.current().kind == StepKind::run;
    if (begun && !runIsOnItsWay) {
        m_leftOff = m_steps.current();
        m_goesOut = m_leftOff->out;
    }
    m_steps.all.resize(m_steps.index + (runIsOnItsWay ? 1 : 0));
    m_steps.begun = runIsOnItsWay;
    m_steps.append({K3Plan::toNormal(false)});
}

// A word that is in OUT may be taken, whether it was confirmed or not.
bool K3Run::hasTaken() const
{
    const bool parameterizes =
        m_reading.state == EncoderState::parameterization && job<ReadParameters>() == nullptr;
    return parameterizes || !m_confirmed.values.empty() || !m_account.outcome.written.empty() ||
           m_cams.hasTaken() || std::ranges::any_of(m_steps.sent(), mayBeTaken);
}

// The word that is in OUT, or on its way there, may be carried out; what it has confirmed may become active.
void K3Run::doubt(InDoubt &doubt, bool nextMayBeSent)
{
    const Word last = m_encoder.knowledge.lastOut();
    const bool isSent = m_steps.begun && !m_steps.atEnd() && (nextMayBeSent || m_steps.current().out == last);
    const Word out = isSent ? m_steps.current().out : nextMayBeSent ? m_goesOut.value_or(last) : last;
    if (out == k3::run) {
        doubt.values = std::exchange(m_confirmed.values, {});
        doubt.reset = std::exchange(m_confirmed.reset, false);
    }
    if (mayLeftOffAct(nextMayBeSent))
        doubtStep(doubt, *m_leftOff);
    if (isSent)
        doubtStep(doubt, m_steps.current());
    doubtCams(doubt);
    doubt.eepromWrites = m_encoder.loseSight(out);
    if (out != k3::normalRunning)
        doubt.out = {out};
}

void K3Run::doubtStep(InDoubt &doubt, const K3Step &step)
{
    if (const auto value = valueGivenBy(step)) {
        replaceValue(doubt.values, *value);
        doubt.uncounted.push_back(value->parameter);
    } else
        doubt.reset = doubt.reset || (step.kind == StepKind::parameter && !step.parameter());
    doubt.position = doubt.position || setsPosition(step);
    if (step.kind == StepKind::camParameter)
        doubt.camPrograms = {step.camProgram};
}

// Acknowledged and not saved, so that it may be lost, or saved meanwhile.
void K3Run::doubtCams(InDoubt &doubt) const
{
    const auto unsaved = m_encoder.knowledge.unsavedCams();
    if (unsaved && std::ranges::count(doubt.camPrograms, *unsaved) == 0)
        doubt.camPrograms.push_back(*unsaved);
}

bool K3Run::mayLeftOffAct(bool nextMayBeSent) const
{
    const bool hasGone = !m_goesOut || *m_goesOut == m_encoder.knowledge.lastOut() || hasGoneOut(*m_goesOut);
    return m_leftOff && (nextMayBeSent || hasGone);
}

bool K3Run::mayStillAct(bool hasGoneOut) const
{
    const auto acts = [](const K3Step &step) {
        return mayBeTaken(step) || setsPosition(step) || step.out == k3::run ||
               step.kind == StepKind::switchMode;
    };
    const bool isSent = m_steps.begun && !m_steps.atEnd() &&
                        (hasGoneOut || m_steps.current().out == m_encoder.knowledge.lastOut());
    return (isSent && acts(m_steps.current())) || (mayLeftOffAct(false) && acts(*m_leftOff));
}

// What was under way when the job was cancelled may still be confirmed.
void K3Run::lookForLateAnswer(Word in)
{
    if (!m_late)
        return;
    const auto fate = m_late->fate(in, m_encoder.device.dialect.as<k3::Dialect>());
    if (fate == K3LateAnswer::Fate::open)
        return;
    const K3Step step = std::exchange(m_late, std::nullopt)->step();
    if (fate == K3LateAnswer::Fate::refused)
        return;
    if (const auto value = valueGivenBy(step))
        replaceValue(m_confirmed.values, *value);
    else
        m_cams.wordTaken(step.out);
}

// Only run ends a parameterization. An encoder that is in operation before run was sent has restarted and
// dropped what it had confirmed.
void K3Run::lookForRestart(Word in)
{
    const bool isBegun = m_steps.begun && !m_steps.atEnd();
    const bool confirmsNow =
        isBegun && m_steps.current().kind == StepKind::parameter && m_handshake.hasConfirmed();
    const bool hasConfirmed =
        !m_confirmed.values.empty() || m_confirmed.reset || m_cams.hasPending() || confirmsNow;
    const bool runIsSent = isBegun && m_steps.current().out == k3::run;
    if (!hasConfirmed || runIsSent || !k3::isOperation(in))
        return;
    dropConfirmed();
    if (job<SendWords>() == nullptr && !leavesOff() && !m_failure)
        fail({RefusalKind::device, WordRefusalId::restarted, {in}});
}

void K3Run::dropConfirmed()
{
    m_confirmed = {};
    m_resetIsSent = false;
    m_cams.losePending();
}

// OUT is 0 again. If the encoder has taken something, the user's choice comes next.
K3Steps K3Run::stepsOfCancel(Word in)
{
    m_late.reset();
    const bool parameterizing = m_encoder.stateOf(in) == EncoderState::parameterization;
    const bool ranMeanwhile = !m_account.outcome.written.empty() || m_cams.hasTaken();
    if (m_cancelled == OnCancel::runWithWhatItHas && parameterizing)
        return m_encoder.plan.endParameterization({}, true);
    if (m_cancelled == OnCancel::restorePrevious && mayRestore() && (parameterizing || ranMeanwhile))
        return stepsToRestore(parameterizing);
    return {};
}

// What was written and read back so far no longer holds.
K3Steps K3Run::stepsToRestore(bool parameterizing)
{
    ParameterValues taken = m_account.outcome.written;
    for (const ParameterValue &value : m_confirmed.values)
        replaceValue(taken, value);
    m_restores = m_cams.hasTaken() || !taken.empty();
    m_mismatch.reset();
    K3Steps cams = m_cams.stepsToRestore();
    return m_cams.hasTaken() ? cams : stepsToRestore(taken, parameterizing);
}

// What was written as it had been before is not written again, but read back like the others.
K3Steps K3Run::stepsToRestore(const ParameterValues &taken, bool parameterizing) const
{
    K3Steps steps = m_encoder.plan.endParameterization(m_account.valuesBefore(taken), parameterizing);
    for (const ParameterValue &value : taken)
        if (findValue(m_account.before, value.parameter) == value.value)
            m_encoder.plan.appendRead(steps, value.parameter, value.value.number());
    return steps;
}

bool K3Run::isPositionStep(const K3Step &step) const
{
    return setsPosition(step) ||
           (step.kind == StepKind::word && (step.out == k3::initialisePreset || step.out == k3::frabaPreset));
}

bool K3Run::canRestore() const
{
    return !resetsToDefault(m_job) && // run would carry out the reset
           m_account.knowsBefore(m_confirmed.values) && WordRun::canRestore() && m_cams.canRestore();
}

} // namespace codewheel
