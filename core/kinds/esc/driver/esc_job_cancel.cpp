// SPDX-License-Identifier: GPL-3.0-or-later
// How a job on a serial line ends before its end. What was sent cannot be taken back: its answer is waited
// for, and what the encoder has then is read.
#include "kinds/esc/driver/esc_job.h"
#include "kinds/esc/driver/esc_values.h"
#include "kinds/esc/protocol/esc_refusals.h"

#include <algorithm>
#include <span>

namespace codewheel {
namespace {

using Sent = std::span<const EscStep>;

bool wasWritten(Sent sent, Parameter parameter)
{
    return std::ranges::any_of(sent, [&](const EscStep &step) {
        return step.task == EscStep::Task::write && step.parameter() == parameter;
    });
}

bool wasScalingWritten(Sent sent)
{
    return std::ranges::any_of(sent, [](const EscStep &step) {
        return step.task == EscStep::Task::write && step.parameter() && isEscScaling(*step.parameter());
    });
}

bool wasAnythingWritten(Sent sent)
{
    return std::ranges::any_of(sent, [](const EscStep &step) { return step.task == EscStep::Task::write; });
}

bool wasPresetSent(Sent sent)
{
    return std::ranges::any_of(
        sent, [](const EscStep &step) { return step.request.command == esc::Command::writePreset; });
}

// Whether reading this tells what the encoder took of what was sent.
bool tellsOf(Sent sent, const EscStep &step)
{
    switch (step.task) {
    case EscStep::Task::positionAfter:
        return wasAnythingWritten(sent);
    case EscStep::Task::refresh:
        if (step.parameter() == Parameter::preset)
            return wasPresetSent(sent);
        return step.parameter() && isEscScaling(*step.parameter()) && wasScalingWritten(sent);
    case EscStep::Task::readBack:
    case EscStep::Task::search:
        return step.parameter() && wasWritten(sent, *step.parameter());
    case EscStep::Task::read:
    case EscStep::Task::write:
    case EscStep::Task::positionBefore:
        break;
    }
    return false;
}

} // namespace

void EscJob::leaveOffAt(Instant /*now*/)
{
    const Sent done = Sent(m_steps.all).first(m_steps.index);
    m_steps.begun = m_isUnderWay || (m_steps.begun && tellsOf(done, m_steps.current()));
    dropFrom(m_steps.index + (m_steps.begun ? 1 : 0));
    settle();
}

// A write that was sent counts as carried out, whether it was answered or not.
bool EscJob::hasTaken() const
{
    return !m_account.outcome.written.empty() || wasAnythingWritten(m_steps.sent());
}

bool EscJob::isPositionStep(const EscStep &step) const
{
    return job<SetPreset>() != nullptr && step.task == EscStep::Task::write;
}

bool EscJob::hasYetToWrite() const
{
    const bool isEnding = isDone() || m_failure || m_cancelled;
    return !isEnding && !waits() && job<ReadParameters>() == nullptr && !hasTaken();
}

void EscJob::endUnsent(std::chrono::seconds unanswered)
{
    finish(refuse(RefusalKind::device, EscRefusalId::notSentInTime, {std::int64_t{unanswered.count()}}));
}

// A write that waits for its answer may have been carried out, so the outcome counts it; for the encoder it
// is counted by whoever gets the answer, or learns that there is none. A write without an answer that was
// still to be looked for in the encoder is counted here.
void EscJob::stop(const Refusal &why)
{
    if (isDone())
        return;
    const bool isWriting = m_isUnderWay && m_steps.current().task == EscStep::Task::write;
    if (isWriting) {
        m_encoder.mayHaveChanged(m_steps.current().request.command);
        ++m_account.outcome.eepromWrites;
    }
    if (m_unanswered)
        m_encoder.values.countEepromWrite();
    if (isWriting || m_unanswered)
        finish(refuse(why.kind, RefusalId::stoppedInWrite,
                      {QString::fromLatin1(isWriting ? m_steps.current().line : m_unanswered->line)}));
    else
        finish(tl::unexpected(why));
}

// What was not written, or was refused, is unchanged. Scaling values are read all the same: one of them
// changes the others.
void EscJob::dropFrom(std::size_t first, std::optional<Parameter> refused)
{
    const Sent sent = Sent(m_steps.all).first(first);
    EscSteps left(sent.begin(), sent.end());
    for (EscStep step : Sent(m_steps.all).subspan(first)) {
        const bool isWritten =
            step.parameter() && step.parameter() != refused && wasWritten(sent, *step.parameter());
        if (step.task == EscStep::Task::readBack && !isWritten)
            step.task = EscStep::Task::refresh;
        if (tellsOf(sent, step) && (isWritten || step.task != EscStep::Task::search))
            left.push_back(step);
    }
    m_steps.all = std::move(left);
}

// Writing the old steps sets the revolutions, as writing the new ones did; the factor is that of before, and
// not one computed from them.
void EscJob::giveBack()
{
    m_restores = true;
    const ParameterValues &before = m_account.before;
    ParameterValues values = m_account.valuesBefore(m_account.outcome.written);
    for (const ParameterValue &along : escSetAlong(values, before))
        if (const auto was = valueOf(before, along.parameter))
            values.push_back({along.parameter, *was});
    const auto factor = valueOf(before, Parameter::scalingFactor);
    if (factor && goesAlongOnEsc(Parameter::scalingFactor, values))
        replaceValue(values, {Parameter::scalingFactor, *factor});
    m_steps.append(m_encoder.plan().writes(values));
}

} // namespace codewheel
