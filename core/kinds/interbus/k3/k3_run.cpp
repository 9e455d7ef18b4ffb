// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_run.h"

#include "kinds/interbus/k3/k3_refine.h"
#include "kinds/interbus/k3/k3_refusal.h"
#include "kinds/interbus/words/k3_cam_fields.h"
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/position_code.h"
#include "kinds/interbus/words/word_reach.h"
#include "kinds/interbus/words/word_refusals.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace codewheel {
namespace {

constexpr std::int64_t fastestShaft = 30'000; // revolutions per minute (assumed): a larger IN is no speed

// What was written is read back where the encoder can be read.
Evidence evidenceOf(const ParameterValues &written, const DeviceDescription &device)
{
    const bool isRead = std::ranges::all_of(
        written, [&](const ParameterValue &value) { return device.find(value.parameter)->canBeRead; });
    return isRead ? Evidence::read : Evidence::echoed;
}

// In cam mode the words of velocity mode are acknowledged: they set the active cams there.
Refusal notSwitched(Word in)
{
    for (const Word out : {k3::velocityOn, k3::velocityOff})
        if (in == (out | k3::confirmation))
            return {RefusalKind::device, RefusalId::takenAsCamWord, {out, in}};
    return {RefusalKind::device, RefusalId::modeNotSwitched, {in}};
}

} // namespace

K3Run::K3Run(JobId id, const Job &job, Pace pace, K3Encoder &encoder)
    : WordRun(id, job, pace, encoder.knowledge.known(), encoder.reading, encoder.events)
    , m_encoder(encoder)
    , m_handshake(encoder.device.dialect.as<k3::Dialect>(), encoder.timing)
    , m_cams(encoder)
    , m_modeBefore(modeNow())
{
    m_encoder.knowledge.beginJob();
}

Result<void> K3Run::plan(Word in, Word out)
{
    const EncoderState state = m_encoder.stateOf(in);
    m_foundParameterizing = state == EncoderState::parameterization;
    if (auto checked = m_encoder.checkState(m_job, in); !checked)
        return checked;
    m_foundInError = state == EncoderState::error;
    if (const auto *end = job<EndParameterization>()) {
        m_restores = !end->restore.empty();
        m_steps.all =
            m_encoder.plan.endParameterization(end->restore, !m_restores || state != EncoderState::error);
    } else {
        m_whatIsDone = whatIsDone(in);
        m_steps.all = m_encoder.plan.stepsFor(m_whatIsDone);
    }
    if (out != k3::normalRunning || state == EncoderState::readOut)
        K3Plan::clearOutFirst(m_steps.all, m_job);
    return {};
}

// Error 1 or 3: what can be read from it is not what it works with, or what run will check. It gets all
// values.
Job K3Run::whatIsDone(Word in) const
{
    Job what = m_job;
    const DeviceError *error = m_encoder.isError(in) ? m_encoder.device.findError(k3::number(in)) : nullptr;
    const bool holdsOthers = error != nullptr && (error->meaning == RefusalId::parametersLost ||
                                                  error->meaning == RefusalId::wrongParameterData);
    if (auto *write = std::get_if<WriteParameters>(&what); write != nullptr && holdsOthers)
        write->onlyWhatDiffers = false;
    return what;
}

void K3Run::watch(Word in, Word out)
{
    m_goesOut.reset();
    lookForLateAnswer(in);
    if (m_leftOff && !m_late && out != m_leftOff->out)
        m_leftOff.reset();
    lookForRestart(in);
}

// Whether the previous step was of that kind.
bool K3Run::follows(StepKind kind) const
{
    return m_steps.index > 0 && m_steps.all[m_steps.index - 1].kind == kind;
}

// The word after 60000000 waits for nobody: 60000000 lasts one cycle.
bool K3Run::mayBegin(Word in)
{
    if (goesByItself() || follows(StepKind::manufacturerPreset))
        return true;
    if (ask())
        m_inWhenAsked = in;
    else if (in != m_inWhenAsked && m_encoder.isError(in))
        fail(refusalFor(in));
    return false;
}

std::optional<Refusal> K3Run::whyNotNow(Word in) const
{
    return setsPosition(m_steps.current()) && in == k3::error ? std::optional(noValidPosition())
                                                              : std::nullopt;
}

void K3Run::begin(Word in, Instant now)
{
    if (m_encoder.knowledge.isManufacturerPreset(m_steps.current().out))
        lastOneCycle();
    K3Step &step = m_steps.current();
    step.inCamMode = m_encoder.knowledge.mode() == Mode::cam;
    m_resetIsSent = m_resetIsSent || (!step.inCamMode && isReset(step.out));
    m_maySwitchMode = m_maySwitchMode || step.effect == Effect::switchesMode || k3::isProgramWord(step.out);
    m_handshake.begin(step, in, now);
    if (setsPosition(step) || step.standsUntilItActs)
        m_encoder.preset.begin(presetTarget(m_encoder.device, m_encoder.knowledge), now);
    if (setsPosition(step)) {
        m_account.outcome.positionBefore = m_reading.position;
        m_wasArmed = m_encoder.knowledge.isPresetArmed().value_or(false);
        m_mayBeInRpm = m_encoder.knowledge.modeIsOnlyTold() && std::abs(k3::signedData(in)) <= fastestShaft;
    }
}

// 60000000, even in words given by the user: another word follows it in OUT, so that its effect is seen.
void K3Run::lastOneCycle()
{
    if (m_steps.current().kind == StepKind::word && m_steps.index + 1 == m_steps.all.size()) {
        K3Step normal = m_steps.current();
        normal.out = k3::normalRunning;
        m_steps.append({normal});
    }
    m_steps.current().kind = StepKind::manufacturerPreset;
}

WordAnswer K3Run::answerTo(Word in, Word out, Instant now)
{
    const WordAnswer answer = m_handshake.cycle(in, out, now);
    return answer == WordAnswer::done && isHeldBack(in, now) ? WordAnswer::waiting : answer;
}

bool K3Run::isHeldBack(Word in, Instant now) const
{
    return presetIsOpen(in, now) || (m_late && m_late->isAwaited(in, now, m_encoder.timing.timeOut));
}

void K3Run::stepDone(Word in)
{
    const K3Step step = m_steps.current();
    const bool isPresetShown = showsPreset();
    m_steps.goOn();
    if (isPresetShown)
        judgePreset(in);
    switch (step.kind.as<StepKind>()) {
    case StepKind::parameter:
        if (step.parameter())
            replaceValue(m_confirmed.values, {*step.parameter(), step.value});
        else
            m_confirmed.reset = true;
        break;
    case StepKind::run:
        ran();
        break;
    case StepKind::toNormal:
        if (m_steps.index == 1 && !m_cancelled)
            outIsCleared(in);
        break;
    case StepKind::readOut:
        readDone(step, in);
        break;
    case StepKind::camReadOut:
        if (auto differs = m_cams.readOutDone(step, in); differs && !m_mismatch)
            m_mismatch = std::move(differs);
        break;
    case StepKind::endReadOut:
        camReadOutEnded(step);
        break;
    case StepKind::camParameter:
        m_cams.wordTaken(step.out);
        break;
    case StepKind::word:
        wordDone(step);
        break;
    default:
        break;
    }
    if (hasLeftOffNow())
        m_steps.append(stepsOfCancel(in));
}

// What stood in OUT before, such as a read-out, may have hidden that the encoder is in parameterization.
void K3Run::outIsCleared(Word in)
{
    m_foundParameterizing = m_encoder.stateOf(in) == EncoderState::parameterization;
    if (auto checked = m_encoder.checkState(m_job, in); !checked)
        fail(checked.error());
}

// A word of the user.
void K3Run::wordDone(const K3Step &step)
{
    if (step.inCamMode && fieldSetBy(step.out))
        m_cams.wordTaken(step.out);
    else if (const auto value = valueGivenBy(step))
        replaceValue(m_confirmed.values, *value);
    else if (step.out == k3::run)
        ran();
}

// What was confirmed is active, unless run was answered by an error, or by 00000000h where reading back will
// tell.
void K3Run::ran()
{
    const bool hasRun = m_reading.state != EncoderState::error || m_reading.errorNumber.value_or(0) == 0;
    m_ranAtZero = m_reading.in == 0;
    const bool isUnproven = m_ranAtZero && m_encoder.device.capabilities.reads;
    for (const ParameterValue &value : m_confirmed.values)
        if (hasRun && isUnproven)
            replaceValue(m_unproven, value);
        else if (hasRun)
            m_account.written(value);
    m_confirmed = {};
    m_resetIsSent = false;
    m_cams.ran();
    if (m_ranAtZero)
        readPresetAgain();
}

void K3Run::readDone(const K3Step &step, Word in)
{
    if (step.isBetween)
        return;
    if (m_encoder.knowledge.isDoubtful(step.out & 0xFFFF)) {
        readAgain(step);
        return;
    }
    m_readAgain = 0;
    const auto value = m_encoder.knowledge.valueOfReadOut(*step.parameter(), k3::data(in));
    if (!value)
        return;
    const bool isProven = valueOf(m_unproven, *step.parameter()) == value;
    std::erase_if(m_unproven, [&](const ParameterValue &its) { return its.parameter == *step.parameter(); });
    if (step.expected) {
        verify(step, *value);
        return;
    }
    if (isProven)
        m_account.written({*step.parameter(), *value});
    m_account.read({*step.parameter(), *value});
    if (*step.parameter() == Parameter::presetFlag)
        presetFlagRead(*value);
    refine(m_steps, m_account, m_whatIsDone, m_encoder, {*step.parameter(), *value});
}

// Behind another read-out, so that the same answer cannot be the same torn word.
void K3Run::readAgain(const K3Step &step)
{
    constexpr int mostOften = 4; // one after the other (assumed)
    if (++m_readAgain > mostOften) {
        fail({RefusalKind::link, WordRefusalId::wordsTorn, {m_reading.in}});
        return;
    }
    K3Steps between;
    for (const ParameterDescription &other : m_encoder.device.parameters)
        if (between.empty() && other.canBeRead && k3::readOutWord(*wordReach(other).readOut) != step.out)
            m_encoder.plan.appendRead(between, other.parameter);
    if (between.empty())
        return;
    between.front().isBetween = true;
    between.push_back(step);
    between.push_back(k3Step(StepKind::endReadOut, k3::normalRunning));
    m_steps.all.insert(m_steps.rest() + 1, between.begin(), between.end()); // behind the end of this one
}

// A difference is a failure, but the others are read all the same, so that it is known what the encoder has.
void K3Run::verify(const K3Step &step, std::int64_t value)
{
    const Parameter parameter = *step.parameter();
    if (value == *step.expected) {
        if (!valueOf(m_account.outcome.alreadyThere, parameter))
            m_account.written({parameter, value});
        return;
    }
    m_account.notWritten(parameter);
    if (!m_mismatch)
        m_mismatch = {RefusalKind::device, RefusalId::verificationFailed, {parameter, *step.expected, value}};
}

// After the last read-out of a program comes what is to be written to it, or its verification is complete.
void K3Run::camReadOutEnded(const K3Step &step)
{
    const auto *write = job<WriteCams>();
    if (step.camProgram == 0 || write == nullptr || m_failure || m_cancelled ||
        K3CamRun::readsOn(m_steps, step))
        return;
    if (step.expected && m_mismatch)
        fail(*m_mismatch);
    else if (step.expected)
        m_cams.wasVerified(*write, step.camProgram);
    else if (write->onlyWhatDiffers)
        m_cams.planWrite(m_steps, *write);
}

void K3Run::stepFailed(WordAnswer how, Word in)
{
    const K3Step &step = m_steps.current();
    if (how == WordAnswer::error) {
        answeredByError(in);
    } else if (how == WordAnswer::noAnswer && step.isRepeated && k3::isConfirmation(in)) {
        runBeforeTheRest();
    } else if (how == WordAnswer::noAnswer) {
        fail(whyNoAnswer(step, in));
    } else {
        dropConfirmed();
        fail({RefusalKind::device, WordRefusalId::restarted, {in}});
    }
}

// In cam mode 40000000 is acknowledged: it sets the start of cam 0.
Refusal K3Run::whyNoAnswer(const K3Step &step, Word in)
{
    if (setsPosition(step) && in == k3::error)
        return noValidPosition();
    if (step.out != k3::initialisePreset || in != (step.out | k3::confirmation) || !mayBeInCamMode())
        return noAnswer(in, m_encoder.timing.timeOut);
    m_encoder.doubtMode();
    return {RefusalKind::device, RefusalId::takenAsCamWord, {step.out, in}};
}

// The data did not follow: run comes between, and the numbers are new again.
void K3Run::runBeforeTheRest()
{
    for (auto step = m_steps.rest(); step != m_steps.all.end(); ++step)
        step->isRepeated = false;
    const K3Steps run{K3Plan::runStep(true), K3Plan::toNormal(false)};
    m_steps.all.insert(m_steps.rest(), run.begin(), run.end());
    m_steps.begun = false;
}

// OUT goes back to 0. Run ends an error caused merely by asking for cams; if the encoder was in a
// parameterization before, run would activate what others have sent.
void K3Run::answeredByError(Word in)
{
    const bool runEndsIt =
        onlyAsksForCams(m_steps.current()) && m_encoder.isError(in) && !m_foundParameterizing && !m_failure;
    fail(refusalFor(in));
    if (runEndsIt)
        m_steps.append({K3Plan::runStep(true), K3Plan::toNormal(false)});
}

// OUT goes back to 0, unless the words were given by the user.
void K3Run::fail(Refusal why)
{
    const bool failsAgainAtRun = m_failure && !m_steps.atEnd() && m_steps.current().kind == StepKind::run;
    const bool isFirst = noteFailure(std::move(why));
    if ((isFirst || failsAgainAtRun) && job<SendWords>() == nullptr)
        m_steps.append({K3Plan::toNormal(false)});
}

Refusal K3Run::refusalFor(Word in) const
{
    return k3Refusal({.device = m_encoder.device,
                      .step = m_steps.current(),
                      .isConfirmed = m_handshake.hasConfirmed(),
                      .confirmed = m_confirmed.values,
                      .written = m_account.outcome.written,
                      .inCamMode = m_encoder.knowledge.mode() == Mode::cam,
                      .mayBeInCamMode = mayBeInCamMode(),
                      .foundParameterizing = m_foundParameterizing,
                      .foundInError = m_foundInError},
                     in);
}

bool K3Run::mayBeInCamMode() const
{
    const K3Knowledge &knowledge = m_encoder.knowledge;
    return m_encoder.device.mayHaveModes() && (!knowledge.mode() || knowledge.modeIsOnlyTold());
}

bool K3Run::endsInError(std::size_t step) const
{
    return step + 1 == m_steps.all.size() || m_reading.state == EncoderState::error;
}

Result<void> K3Run::resultAt(Word in)
{
    if (!m_failure && m_mismatch)
        return tl::unexpected(*m_mismatch);
    if (auto ended = WordRun::resultAt(in); !ended)
        return ended;
    if (m_notSet)
        return tl::unexpected(*m_notSet);
    if (job<SwitchMode>() != nullptr && k3::isConfirmation(in))
        return tl::unexpected(notSwitched(in));
    return m_cams.dropLost() ? refuse(RefusalKind::device, WordRefusalId::restarted, {in}) : Result<void>();
}

std::optional<LeftMode> K3Run::modeLeft() const
{
    const LeftMode now = modeNow();
    const auto *to = job<SwitchMode>();
    const bool isWanted = now.mode == Mode::position && (!m_modeBefore.mode || (to && to->mode == now.mode));
    const bool isAsBefore = now == m_modeBefore && (now.mode || !m_maySwitchMode);
    return isWanted || isAsBefore ? std::nullopt : std::optional(now);
}

void K3Run::complete(Outcome &outcome)
{
    outcome.inDoubt.eepromWrites += m_encoder.knowledge.endJob();
    for (const ParameterValue &value : m_unproven)
        replaceValue(outcome.inDoubt.values, value);
    outcome.foundInParameterization = m_foundParameterizing;
    outcome.resetWaits = m_resetIsSent && outcome.leftIn == EncoderState::parameterization;
    if (outcome.leftIn == EncoderState::parameterization || outcome.leftIn == EncoderState::unknown)
        outcome.confirmed = m_confirmed.values;
    if (outcome.leftIn == EncoderState::error)
        outcome.notActive = m_confirmed.values;
    const bool isUnproven = m_ranAtZero && !m_encoder.device.capabilities.reads;
    outcome.onlyZeroSinceRun = m_reading.in == 0 && (isUnproven || job<SwitchMode>() != nullptr);
    if (m_mayBeSpeed)
        m_encoder.doubtMode();
    if (!outcome.result)
        outcome.leftInMode = modeLeft();
    outcome.camsRead = m_cams.read();
    outcome.camsWritten = m_cams.written();
    std::erase_if(outcome.camsWritten, [&](const CamProgram &program) {
        return std::ranges::count(outcome.inDoubt.camPrograms, program.number) != 0; // perhaps not saved
    });
    if (!hasRestored() || m_mismatch)
        return;
    outcome.restored = evidenceOf(outcome.written, m_encoder.device);
    for (const CamProgram &program : m_cams.programsBefore())
        outcome.camsWritten.push_back(program);
}

} // namespace codewheel
