// SPDX-License-Identifier: GPL-3.0-or-later
// The position before and after a preset, and what they say of what became of it.
#include "drivers/esc_job.h"

namespace codewheel {

void EscJob::positionAnswered(const esc::ExchangeResult &result, Instant now)
{
    if (!result.answer) {
        notRead(refusalOf(result));
        return;
    }
    const bool isTaken = hasValue(result.answer) && m_encoder.takePosition(result.answer->value, now);
    const auto state = m_reads.add(*result.answer);
    if (isTaken) {
        positionKnown(now);
        return;
    }
    m_preset.positions = 0;
    if (state == EscAgreement::State::agreed && !hasValue(result.answer))
        notRead(refusalOf(result));
    else if (state == EscAgreement::State::disagreed) // every time something else
        notRead(disagreed());
}

// The first position after the preset may be any, so that one alone says nothing.
void EscJob::positionKnown(Instant now)
{
    if (current().task == EscStep::Task::positionBefore) {
        m_outcome.positionBefore = m_encoder.reading.position;
        m_preset.positionBeforeAt = now;
        stepDone();
    } else if (++m_preset.positions == 2) {
        m_outcome.positionAfter = m_encoder.reading.position;
        presetDone(now);
    }
}

void EscJob::presetDone(Instant now)
{
    const Said position = positionSays(now);
    const Said value = presetValueSays();
    if (m_unanswered)
        judgeUnanswered(position, value);
    else
        judgeAccepted(position, value);
}

// The encoder said that it took the command. Its preset value decides whether it did, and the position must
// not speak against it; that alone proves it only where no shaft can have turned so far.
void EscJob::judgeAccepted(Said position, Said value)
{
    const EscStep step = current();
    const auto isNot = [&](std::int64_t has) {
        fail({RefusalKind::device,
              RefusalId::verificationFailed,
              {Parameter::preset, step.value, std::int64_t{has}}});
    };
    if (value == Said::notDone)
        isNot(*m_preset.valueAfter);
    else if (position == Said::notDone)
        isNot(*m_outcome.positionAfter);
    else if (value == Said::done || position == Said::done)
        stepDone();
    else
        fail({RefusalKind::device,
              RefusalId::escPresetUnproven,
              {QString::fromLatin1(m_preset.line), step.value}});
}

void EscJob::judgeUnanswered(Said position, Said value)
{
    const bool contradict = position != Said::nothing && value != Said::nothing && position != value;
    const Said said = position == Said::nothing ? value : position;
    if (said == Said::nothing || contradict) {
        failAsUnknown();
    } else if (said == Said::notDone) {
        fail({RefusalKind::device, RefusalId::escWriteNotDone, {QString::fromLatin1(m_unanswered->line)}});
    } else {
        m_encoder.values.countEepromWrite();
        m_unanswered.reset();
        stepDone();
    }
}

EscJob::Said EscJob::positionSays(Instant now) const
{
    const EscPositionGuard &guard = m_encoder.guard;
    const std::int64_t after = *m_outcome.positionAfter;
    const bool fromPreset = guard.canReach(current().value, after, now - m_preset.sentAt.value_or(now));
    const bool fromBefore = m_outcome.positionBefore &&
                            guard.canReach(*m_outcome.positionBefore, after, now - m_preset.positionBeforeAt);
    if (fromPreset && fromBefore)
        return Said::nothing;
    return fromPreset ? Said::done : Said::notDone;
}

// Of a command without an answer it tells that it was done only where it was another value before.
EscJob::Said EscJob::presetValueSays() const
{
    if (!m_preset.valueAfter)
        return Said::nothing;
    if (m_preset.valueAfter != current().value)
        return Said::notDone;
    const bool hasChanged = m_preset.valueBefore && m_preset.valueBefore != current().value;
    return hasChanged || !m_unanswered ? Said::done : Said::nothing;
}

} // namespace codewheel
