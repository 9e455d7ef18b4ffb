// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/la66/la66_run.h"

#include "kinds/interbus/words/la66_word.h"
#include "kinds/interbus/words/word_refusals.h"

#include <algorithm>
#include <utility>

namespace codewheel {

La66Run::La66Run(JobId id, const Job &job, Pace pace, La66Encoder &encoder)
    : WordRun(id, job, pace, encoder.knowledge.values(), encoder.reading, encoder.events)
    , m_encoder(encoder)
    , m_handshake(encoder.timing)
{}

// A service bit that somebody left set is taken back first, leaving the rest of its word.
Result<void> La66Run::plan(Word in, Word out)
{
    m_out = out;
    if (la66::isServiceMode(in) || la66::isServiceMode(out)) {
        m_steps.append({La66Plan::endOfService(out)});
        out &= ~la66::serviceBit;
    }
    m_steps.append(m_encoder.plan.stepsFor(m_job, out));
    const auto *end = job<EndParameterization>();
    m_restores = end != nullptr && !end->restore.empty();
    return {};
}

// While an answer is in IN, perhaps a late one to an earlier service, only the service bit may be cleared.
bool La66Run::mayBegin(Word in)
{
    const Word next = m_steps.current().out;
    if (la66::isServiceMode(in) && next != m_out && next != (m_out & ~la66::serviceBit))
        return false;
    return WordRun::mayBegin(in);
}

// The current step is the first in which the encoder receives a new position.
bool La66Run::receivesPosition() const
{
    return job<SetPreset>() != nullptr && m_steps.current().kind == StepKind::service;
}

bool La66Run::isPositionStep(const La66Step &step) const
{
    return job<SetPreset>() != nullptr && step.kind == StepKind::serviceBit;
}

std::optional<Refusal> La66Run::whyNotNow(Word in) const
{
    if (receivesPosition() && la66::hasError(in))
        return Refusal{RefusalKind::device, RefusalId::magnetOutOfRange, {in}};
    return std::nullopt;
}

void La66Run::begin(Word /*in*/, Instant now)
{
    m_out = m_steps.current().out;
    if (receivesPosition())
        m_account.outcome.positionBefore = m_reading.position;
    m_handshake.begin(m_steps.current(), now);
}

void La66Run::stepDone(Word in)
{
    const La66Step step = m_steps.current();
    m_steps.goOn();
    if (step.kind == StepKind::serviceBit)
        serviceDone(step, in);
    else if (step.kind == StepKind::toNormal && job<SetPreset>() != nullptr)
        m_account.outcome.positionAfter = m_reading.position;
    if (hasLeftOffNow() && givesBack())
        giveBack();
}

void La66Run::serviceDone(const La66Step &step, Word in)
{
    if (!step.parameter())
        return;
    if (la66::isWrite(step.out))
        m_account.written({*step.parameter(), step.value});
    else
        readDone(step, la66::data(in));
}

void La66Run::readDone(const La66Step &step, std::int64_t value)
{
    if (step.expected) {
        if (value == *step.expected)
            return;
        m_account.notWritten(*step.parameter());
        fail(
            {RefusalKind::device, RefusalId::verificationFailed, {*step.parameter(), *step.expected, value}});
        return;
    }
    m_account.read({*step.parameter(), value});
    if (const auto *write = job<WriteParameters>();
        write != nullptr && valueOf(write->values, *step.parameter()) == value) {
        replaceValue(m_account.outcome.alreadyThere, {*step.parameter(), value});
        leaveOut(*step.parameter());
    }
}

// What is already there is neither written nor read back. The step that ends the reading stays.
void La66Run::leaveOut(Parameter parameter)
{
    const auto isOfIt = [&](const La66Step &step) { return step.parameter() == parameter; };
    m_steps.all.erase(std::remove_if(m_steps.rest() + 1, m_steps.all.end(), isOfIt), m_steps.all.end());
}

void La66Run::stepFailed(WordAnswer how, Word in)
{
    fail(how == WordAnswer::error ? refusalFor(in) : noAnswer(in, m_encoder.timing.timeOut));
}

// OUT goes back to 0, unless the words were given by the user.
void La66Run::fail(Refusal why)
{
    const bool isFirst = noteFailure(std::move(why));
    if (!isFirst && !la66::isServiceMode(m_out)) // bringing OUT back has itself failed
        return;
    if (job<SendWords>() == nullptr || m_cancelled)
        m_steps.append(La66Plan::wayBack(m_out));
}

Refusal La66Run::refusalFor(Word in) const
{
    return {RefusalKind::device, WordRefusalId::serviceRefused, {std::int64_t{la66::service(in)}, in}};
}

// No later service went well.
bool La66Run::endsInError(std::size_t step) const
{
    return std::none_of(m_steps.all.begin() + static_cast<std::ptrdiff_t>(step) + 1, m_steps.all.end(),
                        [](const La66Step &later) { return later.kind == StepKind::serviceBit; });
}

// A service that was requested counts as carried out, whether it was acknowledged or not.
bool La66Run::hasTaken() const
{
    return !m_account.outcome.written.empty() ||
           std::ranges::any_of(m_steps.sent(), [](const La66Step &step) {
               return step.kind == StepKind::serviceBit && la66::isWrite(step.out);
           });
}

// A service that was requested cannot be taken back: its handshake is completed.
void La66Run::leaveOffAt(Instant /*now*/)
{
    if (!isPrepared())
        return; // nothing was sent
    const bool isAsked = m_steps.begun && m_steps.current().kind == StepKind::serviceBit;
    m_steps.all.resize(m_steps.index + (isAsked ? 1 : 0));
    m_steps.begun = isAsked;
    m_steps.append(La66Plan::wayBack(m_out));
}

// A service is carried out once its service bit is set.
bool La66Run::isWriting(bool nextMayBeSent) const
{
    return m_steps.begun && !m_steps.atEnd() && m_steps.current().kind == StepKind::serviceBit &&
           la66::isWrite(m_steps.current().out) && (nextMayBeSent || m_steps.current().out == m_sent);
}

void La66Run::doubt(InDoubt &doubt, bool nextMayBeSent)
{
    const Word out = nextMayBeSent ? m_out : m_sent;
    if (out != la66::normalMode)
        doubt.out = {out};
    if (!isWriting(nextMayBeSent))
        return;
    const La66Step &step = m_steps.current();
    doubt.eepromWrites = 1;
    doubt.position = job<SetPreset>() != nullptr;
    if (!step.parameter())
        return;
    doubt.values = {{*step.parameter(), step.value}};
    doubt.uncounted = {*step.parameter()};
    m_encoder.forget(*step.parameter());
}

// OUT is 0 again.
void La66Run::giveBack()
{
    m_restores = true;
    m_steps.append(m_encoder.plan.writes(m_account.valuesBefore(m_account.outcome.written)));
    m_steps.append(La66Plan::wayBack(la66::normalMode));
}

void La66Run::complete(Outcome &outcome)
{
    if (hasRestored())
        outcome.restored = Evidence::read; // like everything that is written
}

} // namespace codewheel
