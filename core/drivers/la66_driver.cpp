// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/la66_driver.h"

#include "drivers/la66_reading.h"
#include "words/la66_word.h"

#include <algorithm>
#include <utility>

namespace codewheel {

La66Driver::La66Driver(const DeviceDescription &device, La66Timing timing)
    : m_timing(timing)
    , m_knowledge(device)
    , m_plan(device, timing)
    , m_handshake(timing)
{}

Result<void> La66Driver::begin(JobId id, const Job &job, Pace pace, Word in, Word out, Instant)
{
    if (m_run)
        return refuse(RefusalKind::busy, RefusalId::jobRunning);
    if (auto checked = m_plan.check(job); !checked)
        return checked;
    Run run(id, job, pace, m_knowledge.values().values());
    run.writesBefore = m_knowledge.values().eepromWrites();
    m_run = std::move(run);
    if (m_reading.state != EncoderState::notSeen) // else IN is not known before the first cycle
        prepare(in, out);
    return {};
}

// A service bit that somebody left is taken back first, the rest of its word standing.
void La66Driver::prepare(Word in, Word out)
{
    Run &run = *m_run;
    m_out = out;
    if (la66::isServiceMode(in) || la66::isServiceMode(out)) {
        run.steps = {La66Plan::endOfService(out)};
        out &= ~la66::serviceBit;
    }
    const La66Steps steps = m_plan.stepsFor(run.job, out);
    run.steps.insert(run.steps.end(), steps.begin(), steps.end());
    const auto *end = std::get_if<EndParameterization>(&run.job);
    run.restores = end != nullptr && !end->restore.empty();
    run.prepared = true;
}

void La66Driver::proceed()
{
    if (m_run && m_run->asked)
        m_run->mayBegin = true;
}

void La66Driver::stop(RefusalId why, Instant)
{
    if (m_run)
        finish(refuse(RefusalKind::stopped, why));
}

Word La66Driver::cycle(Word in, Word out, Instant now)
{
    m_knowledge.observe(in, now);
    flushKnowledge();
    m_reading = decodeLa66(in, now);
    m_out = out;
    if (m_run && m_run->needsPlan())
        prepare(in, out);
    return m_run ? carryOn(in, out, now) : out;
}

Word La66Driver::carryOn(Word in, Word out, Instant now)
{
    while (m_run) {
        Run &run = *m_run;
        if (run.index == run.steps.size()) {
            finish(result());
            return out;
        }
        if (!run.begun) {
            if (!mayBeginStep(in))
                return out;
            if (setsPosition() && la66::hasError(in)) {
                fail({RefusalKind::device, RefusalId::magnetOutOfRange, {in}}, out);
                continue;
            }
            beginStep(now);
            return m_out;
        }
        switch (m_handshake.cycle(in, out, now)) {
        case La66Handshake::State::waiting:
            return current().out;
        case La66Handshake::State::done:
            stepDone(in, out);
            break;
        case La66Handshake::State::refused:
            if (goesOnAfterError())
                goOnAfterError(in);
            else
                fail(refused(in), out);
            break;
        case La66Handshake::State::noAnswer:
            fail(noAnswer(in), out);
            break;
        }
    }
    return out;
}

bool La66Driver::goesOnAfterError() const
{
    const auto *send = std::get_if<SendWords>(&m_run->job);
    return send != nullptr && send->afterError == SendWords::AfterError::goOn && !m_run->cancelled;
}

void La66Driver::goOnAfterError(Word in)
{
    Run &run = *m_run;
    run.lastError = refused(in);
    run.lastErrorAt = run.index;
    run.begun = false;
    ++run.index;
}

// By hand, a step waits for proceed(). Bringing OUT back after a failure or a cancel waits for nobody. While
// an answer stands in IN, which may be a late one to a service from before, nothing but the service bit may
// go.
bool La66Driver::mayBeginStep(Word in)
{
    Run &run = *m_run;
    const Word next = current().out;
    if (la66::isServiceMode(in) && next != m_out && next != (m_out & ~la66::serviceBit))
        return false;
    if (run.pace == Pace::byItself || run.failure || run.cancelled || run.mayBegin)
        return true;
    if (!run.asked) {
        run.asked = true;
        reportProgress(true);
    }
    return false;
}

// The current step is the first that the encoder hears of a new position.
bool La66Driver::setsPosition() const
{
    return std::holds_alternative<SetPreset>(m_run->job) && current().kind == StepKind::service;
}

void La66Driver::beginStep(Instant now)
{
    Run &run = *m_run;
    run.begun = true;
    run.mayBegin = false;
    run.asked = false;
    m_out = current().out;
    if (setsPosition())
        run.positionBefore = m_reading.position;
    m_handshake.begin(current(), now);
    reportProgress(false);
}

void La66Driver::stepDone(Word in, Word out)
{
    Run &run = *m_run;
    const La66Step step = current();
    run.begun = false;
    ++run.index;
    if (step.kind == StepKind::serviceBit)
        serviceDone(step, in, out);
    else if (step.kind == StepKind::toNormal && std::holds_alternative<SetPreset>(run.job))
        run.positionAfter = m_reading.position;
    if (run.cancelled && !run.cancelPlanned && run.index == run.steps.size())
        appendRestore();
}

void La66Driver::serviceDone(const La66Step &step, Word in, Word out)
{
    Run &run = *m_run;
    if (!la66::isWrite(step.out)) {
        if (step.parameter)
            readDone(step, la66::data(in), out);
    } else if (step.parameter) {
        replaceValue(run.written, {*step.parameter, step.value});
    }
}

void La66Driver::readDone(const La66Step &step, std::int64_t value, Word out)
{
    Run &run = *m_run;
    if (step.expected) {
        if (value == *step.expected)
            return;
        std::erase_if(run.written,
                      [&](const ParameterValue &one) { return one.parameter == *step.parameter; });
        fail({RefusalKind::device, RefusalId::verificationFailed, {*step.parameter, *step.expected, value}},
             out);
        return;
    }
    replaceValue(run.read, {*step.parameter, value});
    replaceValue(run.before, {*step.parameter, value});
    if (const auto *write = std::get_if<WriteParameters>(&run.job);
        write != nullptr && valueOf(write->values, *step.parameter) == value) {
        replaceValue(run.alreadyThere, {*step.parameter, value});
        leaveOut(*step.parameter);
    }
}

// What is there already is neither written nor read back. The step that ends the reading stays.
void La66Driver::leaveOut(Parameter parameter)
{
    Run &run = *m_run;
    const auto rest = run.steps.begin() + static_cast<std::ptrdiff_t>(run.index) + 1;
    run.steps.erase(std::remove_if(rest, run.steps.end(),
                                   [&](const La66Step &step) { return step.parameter == parameter; }),
                    run.steps.end());
}

// The remaining steps are dropped. OUT goes back to 0, except where the user gave the words himself.
void La66Driver::fail(Refusal why, Word out)
{
    Run &run = *m_run;
    run.steps.resize(run.index);
    run.begun = false;
    const bool isFirst = !run.failure;
    if (isFirst)
        run.failure = std::move(why);
    if (!isFirst && !la66::isServiceMode(out)) // bringing OUT back has failed itself
        return;
    if (std::holds_alternative<SendWords>(run.job) && !run.cancelled)
        return;
    const La66Steps back = La66Plan::wayBack(out);
    run.steps.insert(run.steps.end(), back.begin(), back.end());
}

Result<void> La66Driver::result() const
{
    if (m_run->failure)
        return tl::unexpected(*m_run->failure);
    if (m_run->cancelled)
        return refuse(RefusalKind::stopped, RefusalId::cancelled);
    const bool isLast = std::none_of( // the services after it went well
        m_run->steps.begin() + static_cast<std::ptrdiff_t>(m_run->lastErrorAt) + 1, m_run->steps.end(),
        [](const La66Step &step) { return step.kind == StepKind::serviceBit; });
    if (m_run->lastError && isLast)
        return tl::unexpected(*m_run->lastError);
    return {};
}

void La66Driver::finish(Result<void> result)
{
    flushKnowledge();
    Run run = std::move(*m_run);
    m_run.reset();
    Outcome outcome;
    outcome.job = run.id;
    outcome.result = std::move(result);
    outcome.eepromWrites = m_knowledge.values().eepromWrites() - run.writesBefore;
    outcome.leftIn = m_reading.state;
    outcome.written = std::move(run.written);
    outcome.alreadyThere = std::move(run.alreadyThere);
    outcome.read = std::move(run.read);
    outcome.positionBefore = run.positionBefore;
    outcome.positionAfter = run.positionAfter;
    if (run.restores && run.index == run.steps.size() && !run.failure)
        outcome.restored = Evidence::read; // as all that is written
    m_events.emplace_back(std::move(outcome));
}

void La66Driver::reportProgress(bool waits)
{
    const Run &run = *m_run;
    Progress progress;
    progress.job = run.id;
    progress.index = static_cast<int>(run.index);
    progress.steps.assign(run.steps.begin(), run.steps.end());
    progress.waitsForUser = waits;
    progress.confirmed = run.written;
    progress.canRestore = canRestore();
    progress.hasTaken = hasTaken();
    m_events.emplace_back(std::move(progress));
}

void La66Driver::flushKnowledge()
{
    if (auto changes = m_knowledge.values().takeChanges())
        m_events.emplace_back(std::move(*changes));
}

std::vector<Event> La66Driver::takeEvents()
{
    return std::exchange(m_events, {});
}

Refusal La66Driver::refused(Word in) const
{
    return {RefusalKind::device, RefusalId::serviceRefused, {std::int64_t{la66::service(in)}, in}};
}

Refusal La66Driver::noAnswer(Word in) const
{
    return {RefusalKind::device,
            RefusalId::noAnswer,
            {std::chrono::duration<double>(m_timing.timeOut).count(), current().out, in}};
}

} // namespace codewheel
