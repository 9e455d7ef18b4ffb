// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/k3_driver.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

// 2080000p ends a cam parameterization, but not one of parameters.
bool isAboutCams(const Job &job)
{
    const auto *to = std::get_if<SwitchMode>(&job);
    return std::holds_alternative<ReadCams>(job) || std::holds_alternative<WriteCams>(job) ||
           (to != nullptr && to->mode == Mode::cam);
}

bool isStartedInOperation(const Job &job)
{
    const auto *to = std::get_if<SwitchMode>(&job);
    return std::holds_alternative<WriteParameters>(job) || std::holds_alternative<SetPreset>(job) ||
           std::holds_alternative<ResetToDefault>(job) || (to != nullptr && to->mode == Mode::velocity);
}

// The values of the job. In cam mode their words are wrong commands (FRABA manual 10.6).
ParameterValues valuesOf(const Job &job)
{
    if (const auto *write = std::get_if<WriteParameters>(&job))
        return write->values;
    const auto *end = std::get_if<EndParameterization>(&job);
    return end != nullptr ? end->restore : ParameterValues{};
}

// The word of the job that sets something else in cam mode (FRABA manual 10.2 and 10.5).
std::optional<Word> wordOfTwoMeanings(const Job &job)
{
    if (const auto *preset = std::get_if<SetPreset>(&job))
        return preset->command == PresetCommand::manufacturer ? k3::frabaPreset : k3::initialisePreset;
    if (const auto *to = std::get_if<SwitchMode>(&job); to != nullptr && to->mode == Mode::velocity)
        return k3::velocityOn;
    return initialisesPreset(job) ? std::optional(k3::initialisePreset) : std::nullopt;
}

bool setsPosition(const K3Step &step)
{
    return step.kind == StepKind::initialisePreset || step.kind == StepKind::manufacturerPreset;
}

} // namespace

K3Driver::K3Driver(const DeviceDescription &device, K3Timing timing)
    : m_device(device)
    , m_timing(timing)
    , m_knowledge(device)
    , m_plan(device, m_knowledge)
    , m_handshake(device.dialect, timing)
    , m_view{device.dialect, device.mayHaveModes(), m_knowledge.mode(), m_knowledge.coding(), {}}
{}

void K3Driver::setKnown(const std::vector<Known> &known)
{
    m_knowledge.set(known);
    m_view.coding = m_knowledge.coding();
}

Result<void> K3Driver::begin(JobId id, const Job &job, Pace pace, Word in, Word out, Instant)
{
    if (m_run)
        return refuse(RefusalKind::busy, RefusalId::jobRunning);
    if (auto checked = m_plan.check(job); !checked)
        return checked;
    if (auto checked = checkMode(job); !checked)
        return checked;

    Run run(id, job, pace, m_knowledge.values());
    run.writesBefore = m_knowledge.eepromWrites();
    for (unsigned program = 1; program <= CamProgram::programs; ++program)
        if (const auto known = m_knowledge.cams(program))
            run.cams.before[program] = known->program;
    m_run = std::move(run);
    if (m_reading.state == EncoderState::notSeen)
        return {}; // IN is not known before the first cycle
    auto prepared = prepare(in, out);
    if (!prepared)
        m_run.reset();
    return prepared;
}

// Plans the steps from the state the encoder is in, or says why it must not be.
Result<void> K3Driver::prepare(Word in, Word out)
{
    Run &run = *m_run;
    if (auto checked = checkState(run.job, in); !checked)
        return checked;
    const EncoderState state = stateOf(in, m_device.dialect);
    run.foundParameterizing = state == EncoderState::parameterization;
    if (const auto *end = std::get_if<EndParameterization>(&run.job)) {
        run.steps =
            m_plan.endParameterization(end->restore, end->restore.empty() || state != EncoderState::error);
        run.restores = !end->restore.empty();
    } else {
        run.steps = m_plan.stepsFor(run.job);
    }
    if (out != k3::normalRunning || state == EncoderState::readOut)
        K3Plan::clearOutFirst(run.steps, run.job);
    run.prepared = true;
    return {};
}

Result<void> K3Driver::checkMode(const Job &job) const
{
    if (!m_device.mayHaveModes())
        return {};
    const auto mode = m_knowledge.mode();
    const auto word = wordOfTwoMeanings(job);
    const ParameterValues values = valuesOf(job);
    if (!word && mode == Mode::cam && !values.empty())
        return refuse(RefusalKind::notSupported, RefusalId::inCamMode,
                      {m_plan.parameterWord(values.front().parameter, values.front().value)});
    if (!word)
        return {};
    if (!mode)
        return refuse(RefusalKind::notSupported, RefusalId::modeNotKnown, {*word});
    if (*mode == Mode::cam && !std::holds_alternative<SwitchMode>(job)) // which leaves it first
        return refuse(RefusalKind::notSupported, RefusalId::inCamMode, {*word});
    return {};
}

Result<void> K3Driver::checkState(const Job &job, Word in) const
{
    const bool isOutsideCamMode = isAboutCams(job) && m_knowledge.mode() != Mode::cam;
    if (!isStartedInOperation(job) && !isOutsideCamMode)
        return {};
    if (initialisesPreset(job) && in == k3::error)
        return tl::unexpected(noValidPosition());
    const EncoderState state = stateOf(in, m_device.dialect);
    if (state == EncoderState::parameterization)
        return refuse(RefusalKind::busy, RefusalId::inParameterization, {in});
    if (state == EncoderState::unknown)
        return refuse(RefusalKind::device, RefusalId::unknownState, {in});
    return {};
}

void K3Driver::proceed()
{
    if (m_run && m_run->asked)
        m_run->mayBegin = true;
}

void K3Driver::stop(RefusalId why, Instant)
{
    if (m_run)
        finish(refuse(RefusalKind::stopped, why));
}

Word K3Driver::cycle(Word in, Word out, Instant now)
{
    m_knowledge.observe(in, out, now);
    flushKnowledge();
    m_view.mode = m_knowledge.mode();
    m_view.camProgram = m_knowledge.camProgram();
    m_reading = decodeReading(in, now, m_view);
    if (m_run && m_run->needsPlan()) {
        if (auto prepared = prepare(in, out); !prepared)
            finish(std::move(prepared));
    }
    if (m_run) {
        lookForLateAnswer(in);
        lookForRestart(in);
    }
    const Word next = m_run ? carryOn(in, out, now) : out;
    return m_run || mayStand(next) ? next : k3::normalRunning;
}

Word K3Driver::carryOn(Word in, Word out, Instant now)
{
    while (m_run) {
        Run &run = *m_run;
        if (run.index == run.steps.size()) {
            if (run.failure)
                finish(tl::unexpected(*run.failure));
            else if (run.mismatch)
                finish(tl::unexpected(*run.mismatch));
            else if (run.cancelled)
                finish(refuse(RefusalKind::stopped, RefusalId::cancelled));
            else if (endsInError())
                finish(tl::unexpected(*run.lastError));
            else
                finish(checkCams(in));
            return out;
        }
        if (!run.begun) {
            if (!mayBeginStep(in))
                return out;
            if (setsPosition(current()) && in == k3::error) {
                fail(noValidPosition());
                continue;
            }
            beginStep(in, now);
            return current().out;
        }
        switch (m_handshake.cycle(in, out, now)) {
        case K3Handshake::State::waiting:
            return current().out;
        case K3Handshake::State::done:
            if (isStillProcessing(in, now))
                return current().out;
            stepDone(in);
            break;
        case K3Handshake::State::restarted:
            run.confirmed.clear();
            dropCams();
            fail(restarted(in));
            break;
        case K3Handshake::State::error:
            if (goesOnAfterError())
                goOnAfterError(in);
            else
                failAt(in);
            break;
        case K3Handshake::State::noAnswer:
            fail(setsPosition(current()) && in == k3::error ? noValidPosition() : noAnswer(in));
            break;
        }
    }
    return out;
}

bool K3Driver::goesOnAfterError() const
{
    const auto *send = std::get_if<SendWords>(&m_run->job);
    return send != nullptr && send->afterError == SendWords::AfterError::goOn && !m_run->cancelled;
}

// The next word may be the way out of the error: run, once its cause is gone.
void K3Driver::goOnAfterError(Word in)
{
    Run &run = *m_run;
    run.lastError = refusalFor(in);
    run.lastErrorAt = run.index;
    run.begun = false;
    ++run.index;
}

bool K3Driver::endsInError() const
{
    const Run &run = *m_run;
    return run.lastError &&
           (run.lastErrorAt + 1 == run.steps.size() || m_reading.state == EncoderState::error);
}

// The word behind 60000000 waits for nobody: that one is a cycle long.
bool K3Driver::followsManufacturerPreset() const
{
    return m_run->index > 0 && m_run->steps[m_run->index - 1].kind == StepKind::manufacturerPreset;
}

// By hand, a step waits for proceed(). Bringing OUT back after a failure or a cancel waits for nobody.
bool K3Driver::mayBeginStep(Word in)
{
    Run &run = *m_run;
    if (run.pace == Pace::byItself || run.failure || run.cancelled || run.mayBegin)
        return true;
    if (followsManufacturerPreset())
        return true;
    if (!run.asked) {
        run.asked = true;
        run.inWhenAsked = in;
        reportProgress(true);
    } else if (in != run.inWhenAsked && isErrorAnswer(in, m_device.dialect)) {
        fail(refusalFor(in));
    }
    return false;
}

void K3Driver::beginStep(Word in, Instant now)
{
    Run &run = *m_run;
    run.begun = true;
    run.mayBegin = false;
    run.asked = false;
    if (m_knowledge.isManufacturerPreset(current().out)) { // also where the user gave the words
        if (current().kind == StepKind::word && run.index + 1 == run.steps.size()) {
            K3Step normal = current(); // what follows it in OUT, so that its effect is seen
            normal.out = k3::normalRunning;
            run.steps.push_back(normal);
        }
        run.steps[run.index].kind = StepKind::manufacturerPreset;
    }
    run.steps[run.index].inCamMode = m_knowledge.mode() == Mode::cam;
    m_handshake.begin(current(), in, now);
    if (setsPosition(current()))
        run.positionBefore = m_reading.position;
    reportProgress(false);
}

void K3Driver::stepDone(Word in)
{
    Run &run = *m_run;
    const K3Step step = current();
    run.begun = false;
    ++run.index;
    switch (step.kind) {
    case StepKind::parameter:
        if (step.parameter)
            run.confirmed.push_back({*step.parameter, step.value});
        else
            run.resetConfirmed = true;
        break;
    case StepKind::run:
        ranWithWhatWasConfirmed();
        break;
    case StepKind::toNormal:
        if (run.index > 1 && run.steps[run.index - 2].kind == StepKind::manufacturerPreset)
            run.positionAfter = m_reading.position;
        break;
    case StepKind::initialisePreset:
        run.positionAfter = m_reading.position;
        break;
    case StepKind::readOut:
        readDone(step, in);
        break;
    case StepKind::camReadOut:
        camReadOutDone(step, in);
        break;
    case StepKind::endReadOut:
        camReadOutEnded(step);
        break;
    case StepKind::camParameter:
        camWordTaken(step.out);
        break;
    case StepKind::word:
        if (step.inCamMode && fieldSetBy(step.out))
            camWordTaken(step.out);
        else if (step.parameter)
            replaceValue(run.confirmed, {*step.parameter, k3::data(step.out)});
        else if (step.out == k3::run)
            ranWithWhatWasConfirmed();
        break;
    default:
        break;
    }
    if (run.cancelled && !run.cancelPlanned && run.index == run.steps.size())
        appendCancelSteps(in);
}

void K3Driver::ranWithWhatWasConfirmed()
{
    Run &run = *m_run;
    const bool hasRun = m_reading.state != EncoderState::error || !m_reading.errorNumber.value_or(0);
    run.ranAtZero = m_reading.in == 0;
    if (hasRun && !(run.ranAtZero && m_device.capabilities.reads)) // else the read-back tells
        for (const ParameterValue &value : run.confirmed)
            replaceValue(run.written, value);
    run.confirmed.clear();
    run.resetConfirmed = false;
    run.cams.isPending = false;
}

// The remaining steps are dropped. OUT goes back to 0, except where the user gave the words himself.
void K3Driver::fail(Refusal why)
{
    Run &run = *m_run;
    const bool isOfBringingBack =
        run.failure && run.index < run.steps.size() && current().kind == StepKind::run;
    run.steps.resize(run.index);
    run.begun = false;
    if (!run.failure || isOfBringingBack) {
        if (!run.failure)
            run.failure = std::move(why);
        if (!std::holds_alternative<SendWords>(run.job))
            run.steps.push_back(K3Plan::toNormal(false));
    }
}

void K3Driver::finish(Result<void> result)
{
    flushKnowledge();
    Run run = std::move(*m_run);
    m_run.reset();
    Outcome outcome;
    outcome.job = run.id;
    outcome.result = std::move(result);
    outcome.eepromWrites = m_knowledge.eepromWrites() - run.writesBefore;
    outcome.leftIn = m_reading.state;
    outcome.written = std::move(run.written);
    if (outcome.leftIn == EncoderState::parameterization)
        outcome.confirmed = std::move(run.confirmed);
    outcome.alreadyThere = std::move(run.alreadyThere);
    outcome.read = std::move(run.read);
    outcome.onlyZeroSinceRun = run.ranAtZero && m_reading.in == 0 && !m_device.capabilities.reads;
    outcome.camsRead = std::move(run.cams.read);
    outcome.camsWritten = std::move(run.cams.written);
    outcome.positionBefore = run.positionBefore;
    outcome.positionAfter = run.positionAfter;
    if (hasRestored(run)) {
        outcome.restored = evidenceOf(outcome.written);
        for (const auto &[program, fields] : run.cams.taken)
            outcome.camsWritten.push_back(run.cams.before.at(program));
    }
    m_events.emplace_back(std::move(outcome));
}

bool K3Driver::hasRestored(const Run &run)
{
    return run.restores && run.index == run.steps.size() && !run.failure && !run.mismatch;
}

// What was written is read back where the encoder tells it.
Evidence K3Driver::evidenceOf(const ParameterValues &written) const
{
    const bool isRead = std::ranges::all_of(written, [this](const ParameterValue &value) {
        return m_device.find(value.parameter)->readOut.has_value();
    });
    return isRead ? Evidence::read : Evidence::echoed;
}

void K3Driver::reportProgress(bool waits)
{
    const Run &run = *m_run;
    Progress progress;
    progress.job = run.id;
    progress.index = static_cast<int>(run.index);
    progress.steps.assign(run.steps.begin(), run.steps.end());
    progress.waitsForUser = waits;
    progress.confirmed = run.confirmed;
    progress.canRestore = canRestore();
    progress.hasTaken = hasTaken();
    m_events.emplace_back(std::move(progress));
}

void K3Driver::flushKnowledge()
{
    if (auto changes = m_knowledge.takeChanges()) {
        m_events.emplace_back(std::move(*changes));
        m_view.coding = m_knowledge.coding();
    }
}

std::vector<Event> K3Driver::takeEvents()
{
    return std::exchange(m_events, {});
}

} // namespace codewheel
