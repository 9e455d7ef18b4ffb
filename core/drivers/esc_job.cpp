// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/esc_job.h"

#include "drivers/esc_values.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace codewheel {

EscJob::EscJob(JobId id, Job job, Pace pace, EscEncoder &encoder)
    : m_id(id)
    , m_job(std::move(job))
    , m_pace(pace)
    , m_encoder(encoder)
    , m_steps(encoder.plan().stepsFor(m_job))
    , m_writesBefore(encoder.values.eepromWrites())
    , m_before(encoder.values.values())
{
    m_outcome.job = id;
    if (const auto *write = std::get_if<WriteParameters>(&m_job))
        for (const ParameterValue &value : write->previous)
            replaceValue(m_before, value);
}

std::optional<esc::Request> EscJob::next(Instant now)
{
    settle();
    if (m_isDone || (!m_isBegun && !mayBegin()))
        return std::nullopt;
    if (!m_isBegun)
        begin(now);
    m_isUnderWay = true;
    return m_search ? m_search->request() : current().request;
}

// What follows from the steps that are done: others, or the end.
void EscJob::settle()
{
    if (m_isDone)
        return;
    if (!m_isCompared && (m_index == m_steps.size() || current().task != EscStep::Task::read))
        leaveOutWhatIsThere();
    checkPreset();
    if (m_index == m_steps.size() && m_cancelled == OnCancel::restorePrevious && !m_isRestoring)
        appendRestore();
    if (m_index == m_steps.size())
        finish(result());
}

// By hand, a write waits for proceed(). Reading disturbs nothing, and putting back after a cancel waits for
// nobody.
bool EscJob::mayBegin()
{
    const bool byItself = m_pace == Pace::byItself || current().task != EscStep::Task::write;
    if (byItself || m_failure || m_cancelled || m_mayBegin)
        return true;
    if (!std::exchange(m_waits, true))
        reportProgress(true);
    return false;
}

void EscJob::begin(Instant now)
{
    m_isBegun = true;
    m_waits = m_mayBegin = false;
    const int tries = std::max(m_encoder.settings.readTries, 1);
    m_reads = EscAgreement(tries);
    m_positions = EscPositionAgreement(2 * tries);
    EscStep &step = current();
    step.request.to = m_encoder.address; // another, where the job has changed it
    if (step.task == EscStep::Task::search)
        beginSearch();
    step.line = (m_search ? m_search->request() : step.request).text();
    if (step.request.command == esc::Command::writePreset) {
        m_preset.sentAt = now;
        m_preset.line = step.line;
    }
    reportProgress(false);
}

void EscJob::answered(const esc::ExchangeResult &result, Instant now)
{
    m_isUnderWay = false;
    if (m_isDone)
        return;
    switch (current().task) {
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

void EscJob::stepDone()
{
    ++m_index;
    m_isBegun = false;
}

// What the encoder does not know is left out, and the rest is read. A job that goes on to write only wants to
// compare: what cannot be compared is written.
void EscJob::readAnswered(const esc::ExchangeResult &result, Instant now)
{
    const bool isForItself = std::holds_alternative<ReadParameters>(m_job);
    if (!result.answer) {
        fail(refusalOf(result));
        return;
    }
    switch (m_reads.add(*result.answer)) {
    case EscAgreement::State::wantsMore:
        break;
    case EscAgreement::State::agreed:
        if (hasValue(result.answer)) {
            readAgreed(now);
            break;
        }
        if (isForItself && !m_failure)
            m_failure = refusalOf(result);
        stepDone();
        break;
    case EscAgreement::State::disagreed:
        if (!isForItself) {
            fail(disagreed());
            break;
        }
        if (!m_failure)
            m_failure = disagreed();
        stepDone();
        break;
    }
}

void EscJob::readAgreed(Instant now)
{
    const Parameter parameter = *current().parameter;
    m_encoder.take(current().request.command, m_reads.last(), now);
    const ParameterValue value{parameter, *m_encoder.values.value(parameter)};
    replaceValue(m_outcome.read, value);
    replaceValue(m_before, value);
    stepDone();
}

void EscJob::refreshAnswered(const esc::ExchangeResult &result, Instant now)
{
    if (result.answer) {
        const auto state = m_reads.add(*result.answer);
        if (state == EscAgreement::State::wantsMore)
            return;
        if (state == EscAgreement::State::agreed && hasValue(result.answer)) {
            m_encoder.take(current().request.command, m_reads.last(), now);
            noteWhatWasSetAlong();
            if (current().parameter == Parameter::preset)
                (m_preset.sentAt ? m_preset.valueAfter : m_preset.valueBefore) = m_reads.last().value;
        }
    }
    stepDone();
}

// Steps that were written have set the revolutions, unless these were written too (escSetAlong).
void EscJob::noteWhatWasSetAlong()
{
    const Parameter parameter = current().parameter.value_or(Parameter::preset);
    const auto now = m_encoder.values.value(parameter);
    const bool isSetAlong = now && parameter == Parameter::revolutions &&
                            valueOf(m_outcome.written, Parameter::steps) &&
                            !valueOf(m_outcome.written, parameter);
    if (isSetAlong && valueOf(m_before, parameter) != now)
        replaceValue(m_outcome.setAlong, {parameter, *now});
}

// What is there already is neither written nor read back, unless it must go along with what is not.
void EscJob::leaveOutWhatIsThere()
{
    m_isCompared = true;
    const auto *write = std::get_if<WriteParameters>(&m_job);
    if (write == nullptr || !write->onlyWhatDiffers || m_failure || m_cancelled)
        return;
    ParameterValues there = m_outcome.read;
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
            m_outcome.alreadyThere.push_back(value);
        else
            left.push_back(value);
    }
    m_steps.resize(m_index);
    const EscSteps rest = m_encoder.plan().writes(left);
    m_steps.insert(m_steps.end(), rest.begin(), rest.end());
}

// What has been read before it is known now.
void EscJob::checkPreset()
{
    const bool isNext =
        !m_isBegun && m_index < m_steps.size() && current().request.command == esc::Command::writePreset;
    if (!isNext)
        return;
    if (const auto checked = m_encoder.plan().check(m_job); !checked) {
        m_failure = checked.error();
        m_steps.resize(m_index);
    }
}

Result<void> EscJob::result() const
{
    if (m_failure)
        return tl::unexpected(*m_failure);
    if (m_cancelled)
        return refuse(RefusalKind::stopped, RefusalId::cancelled);
    return {};
}

void EscJob::finish(Result<void> result)
{
    m_encoder.flushKnowledge();
    m_isDone = true;
    m_search.reset();
    m_outcome.result = std::move(result);
    m_outcome.eepromWrites += m_encoder.values.eepromWrites() - m_writesBefore;
    m_outcome.leftIn = m_encoder.reading.state;
    if (m_positionBefore)
        m_outcome.positionBefore = m_positionBefore->sample.position;
    if (m_positionAfter)
        m_outcome.positionAfter = m_positionAfter->sample.position;
    m_encoder.events.emplace_back(m_outcome);
}

void EscJob::reportProgress(bool waits)
{
    Progress progress;
    progress.job = m_id;
    progress.index = static_cast<int>(m_index);
    progress.steps.assign(m_steps.begin(), m_steps.end());
    progress.waitsForUser = waits;
    progress.confirmed = m_outcome.written;
    progress.canRestore = canRestore();
    progress.hasTaken = hasTaken();
    m_encoder.events.emplace_back(std::move(progress));
}

Refusal EscJob::refusalOf(const esc::ExchangeResult &result) const
{
    const QString line = QString::fromLatin1(current().line);
    if (result.answer && result.answer->kind == esc::Answer::Kind::unknownCommand)
        return {RefusalKind::device, RefusalId::escCommandUnknown, {line}};
    if (result.answer && result.answer->kind == esc::Answer::Kind::outOfRange)
        return {RefusalKind::device, RefusalId::escOutOfRange, {line}};
    return {RefusalKind::device, RefusalId::escNoAnswer, {line, std::int64_t{result.sent}}};
}

Refusal EscJob::disagreed() const
{
    const auto shown = [](const esc::Answer &answer) {
        return hasValue(answer) ? RefusalArgument(std::int64_t{answer.value})
                                : RefusalArgument(QString::fromLatin1(answer.text)); // 03, 05
    };
    return {RefusalKind::device,
            RefusalId::escReadsDisagree,
            {current().parameter.value_or(Parameter::preset), shown(m_reads.first()), shown(m_reads.last())}};
}

} // namespace codewheel
