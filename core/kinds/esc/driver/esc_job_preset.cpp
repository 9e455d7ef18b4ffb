// SPDX-License-Identifier: GPL-3.0-or-later
// The position before and after a preset, and what they say of what became of it.
#include "kinds/esc/driver/esc_job.h"
#include "kinds/esc/protocol/esc_refusals.h"

namespace codewheel {

void EscJob::positionAnswered(const esc::ExchangeResult &result, Instant now)
{
    if (!hasValue(result.answer)) {
        if (const Heard heard = hear(result); heard != Heard::tooLittle)
            positionNotRead(whyNotRead(heard, result));
        return;
    }
    m_encoder.takePosition(result.answer->value, now);
    switch (m_positions.add({result.answer->value, now}, m_encoder.guard)) {
    case EscPositionAgreement::State::wantsMore:
        break;
    case EscPositionAgreement::State::agreed:
        positionAgreed();
        break;
    case EscPositionAgreement::State::disagreed: // every read differed: none is reported
        positionStepDone();
        break;
    }
}

void EscJob::positionAgreed()
{
    const EscPresetProof::Position agreed{m_positions.last(), m_positions.speed()};
    if (m_steps.current().task == EscStep::Task::positionAfter)
        m_proof.positionAfter = agreed;
    else if (!m_proof.positionBefore) // when restoring, it was read before the first write
        m_proof.positionBefore = agreed;
    positionStepDone();
}

// When values are written, the position is only part of the account.
void EscJob::positionNotRead(const Refusal &why)
{
    if (job<SetPreset>() != nullptr)
        notRead(why);
    else
        positionStepDone();
}

void EscJob::positionStepDone()
{
    const bool isPreset = job<SetPreset>() != nullptr;
    if (isPreset && m_steps.current().task == EscStep::Task::positionAfter)
        presetDone();
    else
        m_steps.goOn();
}

void EscJob::presetDone()
{
    const std::int64_t preset = m_steps.current().value;
    const Said position = m_proof.positionSays(preset, m_encoder.guard);
    const Said value = m_proof.valueSays(preset, !m_unanswered);
    if (m_unanswered)
        judgeUnanswered(position, value);
    else
        judgeAccepted(position, value);
}

// The encoder says that it accepted the command. Its preset value decides whether it did, and the position
// must not contradict it. If that value was already there, the position must be the preset, give or take what
// the shaft has turned since; if the earlier value is not known, the position alone decides.
void EscJob::judgeAccepted(Said position, Said value)
{
    const EscStep step = m_steps.current();
    const auto isNot = [&](std::int64_t has) {
        fail({RefusalKind::device,
              RefusalId::verificationFailed,
              {Parameter::preset, step.value, std::int64_t{has}}});
    };
    const bool isThere =
        m_proof.valueAfter == step.value && m_proof.hasTurnedFromPreset(step.value, m_encoder.guard);
    if (value == Said::notDone)
        isNot(*m_proof.valueAfter);
    else if (position == Said::notDone)
        isNot(m_proof.positionAfter->sample.position);
    else if (value == Said::done || position == Said::done || isThere)
        m_steps.goOn();
    else
        fail({RefusalKind::device,
              EscRefusalId::presetUnproven,
              {QString::fromLatin1(m_proof.line), step.value}});
}

void EscJob::judgeUnanswered(Said position, Said value)
{
    const bool contradict = position != Said::nothing && value != Said::nothing && position != value;
    const Said said = position == Said::nothing ? value : position;
    if (said == Said::nothing || contradict) {
        failAsUnknown();
    } else if (said == Said::notDone) {
        fail({RefusalKind::device, EscRefusalId::writeNotDone, {QString::fromLatin1(m_unanswered->line)}});
    } else {
        m_encoder.values.countEepromWrite();
        m_unanswered.reset();
        m_steps.goOn();
    }
}

} // namespace codewheel
