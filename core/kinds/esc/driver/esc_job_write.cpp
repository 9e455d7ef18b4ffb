// SPDX-License-Identifier: GPL-3.0-or-later
// A write of a job and what became of it.
#include "kinds/esc/driver/esc_job.h"
#include "kinds/esc/protocol/esc_refusals.h"

#include <algorithm>

namespace codewheel {

void EscJob::writeAnswered(const esc::ExchangeResult &result, Instant now)
{
    if (!result.answer || hasValue(result.answer))
        notAnswered();
    else if (result.answer->kind == esc::Answer::Kind::accepted)
        accepted(now);
    else
        fail(refusalOf(result));
}

void EscJob::accepted(Instant now)
{
    const EscStep &step = m_steps.current();
    m_encoder.mayHaveChanged(step.request.command);
    m_encoder.values.countEepromWrite();
    if (step.parameter()) {
        m_account.written({*step.parameter(), step.value});
        std::erase_if(m_account.outcome.setAlong,
                      [&](const ParameterValue &along) { return along.parameter == *step.parameter(); });
        m_encoder.values.learn({*step.parameter(), step.value, Evidence::echoed, now});
    }
    m_steps.goOn();
}

// It is never sent again automatically: the encoder is read instead, and at once.
void EscJob::notAnswered()
{
    const EscStep step = m_steps.current();
    m_unanswered = step;
    m_encoder.mayHaveChanged(step.request.command);
    m_steps.goOn();
    const bool isNext = !m_steps.atEnd() && m_steps.current().parameter() == step.parameter() &&
                        m_steps.current().task == EscStep::Task::readBack;
    const bool isLookedFor = std::ranges::any_of(m_steps.all, [&](const EscStep &other) {
        return other.task == EscStep::Task::search && other.parameter() == step.parameter();
    });
    if (step.parameter() && !isNext && !isLookedFor)
        m_steps.all.insert(m_steps.rest(), m_encoder.plan().readBack(step));
}

void EscJob::readBackAnswered(const esc::ExchangeResult &result, Instant now)
{
    const Heard heard = hear(result);
    if (heard == Heard::value)
        readBackAgreed(now);
    else if (heard != Heard::tooLittle)
        notRead(whyNotRead(heard, result));
}

void EscJob::readBackAgreed(Instant now)
{
    const EscStep step = m_steps.current();
    m_encoder.take(step.request.command, m_reads.last(), now);
    const std::int64_t has = *m_encoder.values.value(*step.parameter());
    if (has != step.value) {
        isNotThere(has);
        return;
    }
    isThere({*step.parameter(), has});
    m_steps.goOn();
}

// What was written was found in the encoder: a write without an answer was carried out.
void EscJob::isThere(const ParameterValue &value)
{
    if (m_unanswered)
        m_encoder.values.countEepromWrite();
    m_unanswered.reset();
    m_account.written(value);
}

void EscJob::isNotThere(std::int64_t has)
{
    const EscStep step = m_steps.current();
    m_account.notWritten(*step.parameter());
    if (m_unanswered && isBoundToEscFactor(*step.parameter()))
        failAsUnknown(); // if carried out, it would show once the factor is sent, and not before
    else if (m_unanswered)
        fail({RefusalKind::device, EscRefusalId::writeNotDone, {QString::fromLatin1(m_unanswered->line)}});
    else
        fail({RefusalKind::device, RefusalId::verificationFailed, {*step.parameter(), step.value, has}});
}

void EscJob::notRead(const Refusal &why)
{
    if (!m_unanswered) {
        fail(why);
        return;
    }
    failAsUnknown();
    if (why.id == RefusalId::escNoAnswer)
        m_steps.dropRest();
}

// A write that may have reached the EEPROM counts as one.
void EscJob::failAsUnknown()
{
    m_encoder.values.countEepromWrite();
    fail({RefusalKind::device, EscRefusalId::writeUnknown, {QString::fromLatin1(m_unanswered->line)}});
}

// The first failure is reported. What was accepted before is still read back, unless the encoder is silent.
void EscJob::fail(Refusal why)
{
    const bool isSilent = why.id == RefusalId::escNoAnswer || why.id == EscRefusalId::notFoundAgain;
    const std::optional<Parameter> refused =
        m_steps.current().task == EscStep::Task::write ? m_steps.current().parameter() : std::nullopt;
    m_unanswered.reset();
    m_steps.goOn();
    if (isSilent)
        m_steps.dropRest();
    else
        dropFrom(m_steps.index, refused);
    if (!m_failure)
        m_failure = std::move(why);
}

} // namespace codewheel
