// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_job.h"

#include "kinds/esc/protocol/esc_refusals.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace codewheel {

EscJob::EscJob(JobId id, Job job, Pace pace, EscEncoder &encoder)
    : JobRun(id, std::move(job), pace, encoder.values, encoder.reading, encoder.events)
    , m_encoder(encoder)
{
    m_steps.all = encoder.plan().stepsFor(m_job);
}

std::optional<esc::Request> EscJob::next(Instant now)
{
    settle();
    if (isDone() || (!m_steps.begun && !mayBegin()))
        return std::nullopt;
    if (!m_steps.begun)
        begin(now);
    m_isUnderWay = true;
    return m_search ? m_search->request() : m_steps.current().request;
}

// What follows once steps are done: further steps, or the end.
void EscJob::settle()
{
    if (isDone())
        return;
    if (!m_isCompared && (m_steps.atEnd() || m_steps.current().task != EscStep::Task::read))
        leaveOutWhatIsThere();
    checkPreset();
    if (hasLeftOffNow() && givesBack())
        giveBack();
    if (m_steps.atEnd())
        finish(result());
}

// By hand only a write waits: reading disturbs nothing.
bool EscJob::mayBegin()
{
    if (goesByItself() || m_steps.current().task != EscStep::Task::write)
        return true;
    ask();
    return false;
}

void EscJob::begin(Instant now)
{
    beginStep();
    const int tries = std::max(m_encoder.settings.readTries, 1);
    m_reads = EscAgreement(tries);
    m_positions = EscPositionAgreement(2 * tries);
    EscStep &step = m_steps.current();
    step.request.to = m_encoder.address; // a different one once the job has changed it
    if (step.task == EscStep::Task::search)
        beginSearch();
    step.line = (m_search ? m_search->request() : step.request).text();
    if (step.request.command == esc::Command::writePreset) {
        m_proof.sentAt = now;
        m_proof.line = step.line;
    }
    reportProgress(false);
}

void EscJob::answered(const esc::ExchangeResult &result, Instant now)
{
    m_isUnderWay = false;
    if (isDone())
        return;
    switch (m_steps.current().task) {
    case EscStep::Task::read:
        readAnswered(result, now);
        break;
    case EscStep::Task::refresh:
        refreshAnswered(result, now);
        break;
    case EscStep::Task::write:
        writeAnswered(result, now);
        break;
    case EscStep::Task::readBack:
        readBackAnswered(result, now);
        break;
    case EscStep::Task::positionBefore:
    case EscStep::Task::positionAfter:
        positionAnswered(result, now);
        break;
    case EscStep::Task::search:
        searchAnswered(result, now);
        break;
    }
    settle();
}

EscJob::Heard EscJob::hear(const esc::ExchangeResult &result)
{
    if (!result.answer)
        return Heard::nothing;
    switch (m_reads.add(*result.answer)) {
    case EscAgreement::State::wantsMore:
        return Heard::tooLittle;
    case EscAgreement::State::agreed:
        return hasValue(result.answer) ? Heard::value : Heard::error;
    case EscAgreement::State::disagreed:
        break;
    }
    return Heard::contradiction;
}

// What the encoder does not know is left out, and the rest is read. A job that goes on to write only wants to
// compare: what cannot be compared is written.
void EscJob::readAnswered(const esc::ExchangeResult &result, Instant now)
{
    const bool isForItself = job<ReadParameters>() != nullptr;
    const Heard heard = hear(result);
    if (heard == Heard::tooLittle)
        return;
    if (heard == Heard::value) {
        readAgreed(now);
    } else if (heard == Heard::nothing || (heard == Heard::contradiction && !isForItself)) {
        fail(whyNotRead(heard, result));
    } else {
        if (isForItself && !m_failure)
            m_failure = whyNotRead(heard, result);
        m_steps.goOn();
    }
}

void EscJob::readAgreed(Instant now)
{
    const Parameter parameter = *m_steps.current().parameter();
    m_encoder.take(m_steps.current().request.command, m_reads.last(), now);
    const ParameterValue value{parameter, *m_encoder.values.value(parameter)};
    m_account.read(value);
    m_steps.goOn();
}

void EscJob::refreshAnswered(const esc::ExchangeResult &result, Instant now)
{
    const Heard heard = hear(result);
    if (heard == Heard::tooLittle)
        return;
    if (heard == Heard::value) {
        m_encoder.take(m_steps.current().request.command, m_reads.last(), now);
        noteWhatWasSetAlong();
        if (m_steps.current().parameter() == Parameter::preset)
            (m_proof.sentAt ? m_proof.valueAfter : m_proof.valueBefore) = m_reads.last().value;
    }
    m_steps.goOn();
}

// Writing the steps sets the revolutions, unless these were written too (escSetAlong).
void EscJob::noteWhatWasSetAlong()
{
    const Parameter parameter = m_steps.current().parameter().value_or(Parameter::preset);
    const auto now = m_encoder.values.value(parameter);
    const bool isSetAlong = now && parameter == Parameter::revolutions &&
                            valueOf(m_account.outcome.written, Parameter::steps) &&
                            !valueOf(m_account.outcome.written, parameter);
    if (isSetAlong && valueOf(m_account.before, parameter) != now)
        replaceValue(m_account.outcome.setAlong, {parameter, *now});
}

// What is already there is neither written nor read back, unless it has to be sent along with something that
// is not.
void EscJob::leaveOutWhatIsThere()
{
    m_isCompared = true;
    const auto *write = job<WriteParameters>();
    if (write == nullptr || !write->onlyWhatDiffers || m_failure || m_cancelled)
        return;
    ParameterValues there = m_account.outcome.read;
    replaceValue(there, {Parameter::lineAddress, m_encoder.address.value});
    if (m_encoder.baudRate)
        replaceValue(there, {Parameter::baudRate, *m_encoder.baudRate});
    const auto isThere = [&](const ParameterValue &value) {
        return valueOf(there, value.parameter) == value.value;
    };
    ParameterValues differing;
    std::ranges::copy_if(write->values, std::back_inserter(differing), std::not_fn(isThere));
    ParameterValues left; // to be written
    for (const ParameterValue &value : write->values) {
        if (isThere(value) && !goesAlongOnEsc(value.parameter, differing))
            m_account.outcome.alreadyThere.push_back(value);
        else
            left.push_back(value);
    }
    m_steps.dropRest();
    m_steps.append(m_encoder.plan().writes(left));
}

// The values read before are known now.
void EscJob::checkPreset()
{
    const bool isNext =
        !m_steps.begun && !m_steps.atEnd() && m_steps.current().request.command == esc::Command::writePreset;
    if (!isNext)
        return;
    if (const auto checked = m_encoder.plan().check(m_job); !checked) {
        m_failure = checked.error();
        m_steps.dropRest();
    }
}

void EscJob::complete(Outcome &outcome)
{
    m_encoder.flushKnowledge();
    m_search.reset();
    if (hasRestored())
        outcome.restored = Evidence::read; // like everything that is written
    if (const auto &before = m_proof.positionBefore)
        outcome.positionBefore = before->sample.position;
    if (const auto &after = m_proof.positionAfter)
        outcome.positionAfter = after->sample.position;
}

Refusal EscJob::refusalOf(const esc::ExchangeResult &result) const
{
    const QString line = QString::fromLatin1(m_steps.current().line);
    if (result.answer && result.answer->kind == esc::Answer::Kind::unknownCommand)
        return {RefusalKind::device, EscRefusalId::commandUnknown, {line}};
    if (result.answer && result.answer->kind == esc::Answer::Kind::outOfRange)
        return {RefusalKind::device, EscRefusalId::outOfRange, {line}};
    return {RefusalKind::device, RefusalId::escNoAnswer, {line, std::int64_t{result.sent}}};
}

Refusal EscJob::whyNotRead(Heard heard, const esc::ExchangeResult &result) const
{
    if (heard != Heard::contradiction)
        return refusalOf(result);
    const auto shown = [](const esc::Answer &answer) {
        return hasValue(answer) ? RefusalArgument(std::int64_t{answer.value})
                                : RefusalArgument(QString::fromLatin1(answer.text)); // 03, 05
    };
    return {RefusalKind::device,
            EscRefusalId::readsDisagree,
            {m_steps.current().parameter().value_or(Parameter::preset), shown(m_reads.first()),
             shown(m_reads.last())}};
}

} // namespace codewheel
