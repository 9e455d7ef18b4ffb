// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/k3_driver.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

void replaceValue(ParameterValues &values, ParameterValue value)
{
    std::erase_if(values, [&](const ParameterValue &other) { return other.parameter == value.parameter; });
    values.push_back(value);
}

// 40000000h sets the start of cam 0 where the encoder is in cam mode.
bool initialisesPreset(const Job &job)
{
    const auto *write = std::get_if<WriteParameters>(&job);
    return std::holds_alternative<SetPreset>(job) || (write != nullptr && write->initialisePreset);
}

bool startsParameterization(const Job &job)
{
    return std::holds_alternative<WriteParameters>(job) || std::holds_alternative<SetPreset>(job);
}

} // namespace

K3Driver::K3Driver(const DeviceDescription &device, K3Timing timing)
    : m_device(device)
    , m_timing(timing)
    , m_knowledge(device)
    , m_plan(device, m_knowledge)
    , m_handshake(device.dialect, timing)
    , m_view{device.dialect, device.quirks.hasModes, m_knowledge.mode(), m_knowledge.coding()}
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
    if (initialisesPreset(job) && m_device.quirks.hasModes && m_knowledge.mode() != Mode::position)
        return refuse(RefusalKind::notSupported, RefusalId::modeNotKnown, {k3::initialisePreset});

    Run run;
    run.id = id;
    run.job = job;
    run.pace = pace;
    run.writesBefore = m_knowledge.eepromWrites();
    run.before = m_knowledge.values();
    if (const auto *write = std::get_if<WriteParameters>(&job))
        for (const ParameterValue &value : write->previous)
            replaceValue(run.before, value);
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
    if (const auto *end = std::get_if<EndParameterization>(&run.job))
        run.steps =
            m_plan.endParameterization(end->restore, end->restore.empty() || state != EncoderState::error);
    else
        run.steps = m_plan.stepsFor(run.job);
    const bool mustClear = out != k3::normalRunning || state == EncoderState::readOut;
    if (mustClear && !std::holds_alternative<SendWords>(run.job))
        run.steps.insert(run.steps.begin(), K3Plan::toNormal(false));
    run.prepared = true;
    return {};
}

Result<void> K3Driver::checkState(const Job &job, Word in) const
{
    if (!startsParameterization(job))
        return {};
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

void K3Driver::cancel(OnCancel how, Instant now)
{
    if (!m_run || m_run->cancelled || m_run->failure)
        return;
    Run &run = *m_run;
    run.cancelled = how;
    run.cancelledAt = now;
    if (run.begun && current().kind == StepKind::parameter) {
        if (m_handshake.hasConfirmed())
            replaceValue(run.confirmed, {*current().parameter, current().value});
        else
            run.inFlight = current();
    }
    const bool runIsOnItsWay = run.begun && current().kind == StepKind::run;
    if (runIsOnItsWay) // cannot be taken back: its answer is waited for
        ++run.index;
    run.steps.resize(run.index);
    run.steps.push_back(K3Plan::toNormal(false));
    if (runIsOnItsWay)
        --run.index;
    else
        run.begun = false;
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
    m_reading = decodeReading(in, now, m_view);
    if (m_run && !m_run->prepared && !m_run->cancelled) {
        if (auto prepared = prepare(in, out); !prepared)
            finish(std::move(prepared));
    }
    if (m_run) {
        lookForLateAnswer(in);
        lookForRestart(in);
    }
    return m_run ? carryOn(in, out, now) : out;
}

// Only run ends a parameterization. An encoder that is in operation before run was sent has started anew, and
// dropped what it had confirmed.
void K3Driver::lookForRestart(Word in)
{
    Run &run = *m_run;
    const bool isBegun = run.begun && run.index < run.steps.size();
    const bool hasConfirmed = !run.confirmed.empty() || (isBegun && current().kind == StepKind::parameter &&
                                                         m_handshake.hasConfirmed());
    const bool runIsSent = isBegun && current().out == k3::run;
    if (!hasConfirmed || runIsSent || !k3::isOperation(in))
        return;
    run.confirmed.clear();
    const bool dropsAnyway = run.cancelled && !run.cancelPlanned;
    if (!std::holds_alternative<SendWords>(run.job) && !dropsAnyway && !run.failure)
        fail(restarted(in));
}

// What was on its way as the job was cancelled may still be confirmed.
void K3Driver::lookForLateAnswer(Word in)
{
    Run &run = *m_run;
    if (!run.cancelled || run.cancelPlanned)
        return;
    if (run.inFlight && k3::isConfirmation(in) && k3::number(in) == k3::number(run.inFlight->out)) {
        replaceValue(run.confirmed, {*run.inFlight->parameter, run.inFlight->value});
        run.inFlight.reset();
    }
}

// Baumer: the new data beside the number from before.
bool K3Driver::isStillProcessing(Word in, Instant now) const
{
    const Run &run = *m_run;
    return run.cancelled && !run.cancelPlanned && run.inFlight && k3::isConfirmation(in) &&
           k3::data(in) == k3::data(run.inFlight->out) && now - run.cancelledAt < m_timing.timeOut;
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
            else
                finish({});
            return out;
        }
        if (!run.begun) {
            if (!mayBeginStep(in))
                return out;
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
            fail(restarted(in));
            break;
        case K3Handshake::State::error:
            fail(refusalFor(in));
            break;
        case K3Handshake::State::noAnswer:
            fail(noAnswer(in));
            break;
        }
    }
    return out;
}

// By hand, a step waits for proceed(). Bringing OUT back after a failure or a cancel waits for nobody.
bool K3Driver::mayBeginStep(Word in)
{
    Run &run = *m_run;
    if (run.pace == Pace::byItself || run.failure || run.cancelled || run.mayBegin)
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
    m_handshake.begin(current(), in, now);
    if (current().kind == StepKind::initialisePreset)
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
        run.confirmed.push_back({*step.parameter, step.value});
        break;
    case StepKind::run:
        ranWithWhatWasConfirmed();
        break;
    case StepKind::initialisePreset:
        run.positionAfter = m_reading.position;
        break;
    case StepKind::readOut:
        readDone(step, in);
        break;
    case StepKind::word:
        if (step.parameter)
            replaceValue(run.confirmed, {*step.parameter, k3::data(step.out)});
        else if (step.out == k3::run)
            ranWithWhatWasConfirmed();
        break;
    case StepKind::toNormal:
    case StepKind::endReadOut:
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
}

void K3Driver::readDone(const K3Step &step, Word in)
{
    const auto value = m_knowledge.valueOfReadOut(*step.parameter, k3::data(in));
    if (!value)
        return;
    if (step.expected) {
        verify(step, *value);
        return;
    }
    replaceValue(m_run->read, {*step.parameter, *value});
    replaceValue(m_run->before, {*step.parameter, *value});
    refine(*step.parameter, *value);
}

// A difference is a failure, but the others are read all the same, so that what the encoder has is known.
void K3Driver::verify(const K3Step &step, std::int64_t value)
{
    Run &run = *m_run;
    if (value == *step.expected) {
        if (!valueOf(run.alreadyThere, *step.parameter))
            replaceValue(run.written, {*step.parameter, value});
        return;
    }
    std::erase_if(run.written, [&](const ParameterValue &one) { return one.parameter == *step.parameter; });
    if (!run.mismatch)
        run.mismatch = {
            RefusalKind::device, RefusalId::verificationFailed, {*step.parameter, *step.expected, value}};
}

// A value that was read changes the rest of the plan: what is already there is left out, steps are sent minus
// 1 where the encoder counts so, and a preset is programmed again only where it is used up.
void K3Driver::refine(Parameter parameter, std::int64_t value)
{
    Run &run = *m_run;
    const auto rest = run.steps.begin() + static_cast<std::ptrdiff_t>(run.index);
    const bool rearms = parameter == Parameter::preset && initialisesPreset(run.job) &&
                        m_device.quirks.presetNeedsRearming &&
                        valueOf(run.read, Parameter::presetFlag).value_or(0) == 0;

    const auto *preset = std::get_if<SetPreset>(&run.job);
    const bool keepsValue = preset != nullptr && !preset->value && parameter == Parameter::preset;
    for (auto step = rest; step != run.steps.end(); ++step) {
        if (step->kind != StepKind::parameter)
            continue;
        if (keepsValue && step->parameter == parameter)
            step->value = value;
        step->out = m_plan.parameterWord(*step->parameter, step->value);
    }
    const auto *write = std::get_if<WriteParameters>(&run.job);
    if (!rearms && (preset != nullptr || (write != nullptr && write->onlyWhatDiffers)))
        leaveOut(parameter, value);
}

void K3Driver::leaveOut(Parameter parameter, std::int64_t value)
{
    Run &run = *m_run;
    const auto rest = [&] { return run.steps.begin() + static_cast<std::ptrdiff_t>(run.index); };
    const auto write = std::find_if(rest(), run.steps.end(), [&](const K3Step &step) {
        return step.kind == StepKind::parameter && step.parameter == parameter && step.value == value;
    });
    if (write == run.steps.end())
        return;
    run.steps.erase(write);
    replaceValue(run.alreadyThere, {parameter, value});
    const auto verify = std::find_if(rest(), run.steps.end(), [&](const K3Step &step) {
        return step.parameter == parameter && step.expected.has_value();
    });
    if (verify != run.steps.end())
        run.steps.erase(verify, verify + 2); // with the end of its read-out

    const auto isWrite = [](const K3Step &step) { return step.kind == StepKind::parameter; };
    if (std::any_of(rest(), run.steps.end(), isWrite))
        return;
    const auto runStep =
        std::find_if(rest(), run.steps.end(), [](const K3Step &s) { return s.kind == StepKind::run; });
    if (runStep != run.steps.end())
        run.steps.erase(runStep, runStep + 2); // with the 00000000 behind it
}

// The remaining steps are dropped. OUT goes back to 0, except where the user gave the words himself.
void K3Driver::fail(Refusal why)
{
    Run &run = *m_run;
    run.steps.resize(run.index);
    run.begun = false;
    if (!run.failure) {
        run.failure = std::move(why);
        if (!std::holds_alternative<SendWords>(run.job))
            run.steps.push_back(K3Plan::toNormal(false));
    }
}

// OUT is 0 again. Where the encoder has taken something, the user's choice follows.
void K3Driver::appendCancelSteps(Word in)
{
    Run &run = *m_run;
    run.cancelPlanned = true;
    const bool parameterizing = stateOf(in, m_device.dialect) == EncoderState::parameterization;
    const bool ranMeanwhile = !run.written.empty();
    K3Steps steps;
    if (*run.cancelled == OnCancel::runWithWhatItHas && parameterizing)
        steps = m_plan.endParameterization({}, true);
    else if (*run.cancelled == OnCancel::restorePrevious && canRestore() && (parameterizing || ranMeanwhile))
        steps = m_plan.endParameterization(valuesToRestore(), parameterizing);
    run.steps.insert(run.steps.end(), steps.begin(), steps.end());
}

bool K3Driver::canRestore() const
{
    const auto isKnown = [this](const ParameterValue &value) {
        return valueOf(m_run->before, value.parameter).has_value();
    };
    return std::ranges::all_of(m_run->confirmed, isKnown) && std::ranges::all_of(m_run->written, isKnown);
}

ParameterValues K3Driver::valuesToRestore() const
{
    ParameterValues values;
    for (const ParameterValues *taken : {&m_run->written, &m_run->confirmed})
        for (const ParameterValue &value : *taken)
            replaceValue(values, {value.parameter, *valueOf(m_run->before, value.parameter)});
    return values;
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
    outcome.alreadyThere = std::move(run.alreadyThere);
    outcome.read = std::move(run.read);
    outcome.onlyZeroSinceRun = run.ranAtZero && m_reading.in == 0 && !m_device.capabilities.reads;
    outcome.positionBefore = run.positionBefore;
    outcome.positionAfter = run.positionAfter;
    m_events.emplace_back(std::move(outcome));
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
    m_events.emplace_back(std::move(progress));
}

Refusal K3Driver::refusalFor(Word in) const
{
    if (current().kind == StepKind::readOut || k3::isReadOutRequest(current().out)) {
        if (stateOf(in, m_device.dialect) == EncoderState::readOut)
            return {
                RefusalKind::device, RefusalId::readOutUnknown, {std::int64_t{current().out & 0xFFFF}, in}};
    }
    const unsigned number = k3::number(in);
    const DeviceError *error = m_device.findError(number);
    const RefusalId id = error != nullptr ? error->meaning : RefusalId::otherDeviceError;
    std::vector<RefusalArgument> arguments;
    if (id == RefusalId::wrongParameterData || id == RefusalId::unknownParameterNumber)
        arguments = suspects();
    else if (id == RefusalId::manufacturerError)
        arguments = {std::int64_t{in & 0xFF}};
    else if (id == RefusalId::otherDeviceError)
        arguments = {std::int64_t{number}};
    arguments.emplace_back(in);
    return {RefusalKind::device, id, std::move(arguments)};
}

// An error that comes before the word was confirmed may be about the one before; an error at run is about the
// set.
std::vector<RefusalArgument> K3Driver::suspects() const
{
    const Run &run = *m_run;
    std::vector<RefusalArgument> suspects;
    const K3Step &step = current();
    if (k3::isParameterWord(step.out)) {
        if (!m_handshake.hasConfirmed() && !run.confirmed.empty())
            suspects.emplace_back(run.confirmed.back().parameter);
        if (step.parameter)
            suspects.emplace_back(*step.parameter);
        else
            suspects.emplace_back(std::int64_t{k3::number(step.out)});
        return suspects;
    }
    for (const ParameterValues *taken : {&run.confirmed, &run.written})
        for (const ParameterValue &value : *taken)
            suspects.emplace_back(value.parameter);
    return suspects;
}

Refusal K3Driver::noAnswer(Word in) const
{
    return {RefusalKind::device,
            RefusalId::noAnswer,
            {std::chrono::duration<double>(m_timing.timeOut).count(), current().out, in}};
}

Refusal K3Driver::restarted(Word in)
{
    return {RefusalKind::device, RefusalId::restarted, {in}};
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
