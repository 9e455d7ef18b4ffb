// SPDX-License-Identifier: GPL-3.0-or-later
// The position before and after a preset, and what they say of what became of it.
#include "drivers/esc_job.h"

#include <algorithm>
#include <cmath>

namespace codewheel {
namespace {

// Between a position and the answer that told of it, or a command and its being carried out, lies what the
// line and the adapter take (assumed).
constexpr double longestDelay = 50'000; // us
constexpr double edgeOfStep = 2;        // steps

} // namespace

void EscJob::positionAnswered(const esc::ExchangeResult &result, Instant now)
{
    if (!result.answer) {
        positionNotRead(refusalOf(result));
        return;
    }
    if (!hasValue(result.answer)) {
        const auto errors = m_reads.add(*result.answer);
        if (errors == EscAgreement::State::agreed)
            positionNotRead(refusalOf(result));
        else if (errors == EscAgreement::State::disagreed)
            positionNotRead(disagreed());
        return;
    }
    m_encoder.takePosition(result.answer->value, now);
    switch (m_positions.add({result.answer->value, now}, m_encoder.guard)) {
    case EscPositionAgreement::State::wantsMore:
        break;
    case EscPositionAgreement::State::agreed:
        positionAgreed();
        break;
    case EscPositionAgreement::State::disagreed: // every time something else: it is not told
        positionStepDone();
        break;
    }
}

void EscJob::positionAgreed()
{
    const AgreedPosition agreed{m_positions.last(), m_positions.speed()};
    if (m_steps.current().task == EscStep::Task::positionAfter)
        m_positionAfter = agreed;
    else if (!m_positionBefore) // giving values back, it was there before the first of them
        m_positionBefore = agreed;
    positionStepDone();
}

// Beside values that are written the position only stands in the account.
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
    const Said position = positionSays();
    const Said value = presetValueSays();
    if (m_unanswered)
        judgeUnanswered(position, value);
    else
        judgeAccepted(position, value);
}

// The encoder said that it took the command. Its preset value decides whether it did, and the position must
// not speak against it. Where that value was there before, the position must be the preset give or take what
// the shaft turned since; where nobody knows it, the position alone must tell.
void EscJob::judgeAccepted(Said position, Said value)
{
    const EscStep step = m_steps.current();
    const auto isNot = [&](std::int64_t has) {
        fail({RefusalKind::device,
              RefusalId::verificationFailed,
              {Parameter::preset, step.value, std::int64_t{has}}});
    };
    const bool isThere = m_preset.valueAfter == step.value && hasTurnedFromPreset();
    if (value == Said::notDone)
        isNot(*m_preset.valueAfter);
    else if (position == Said::notDone)
        isNot(m_positionAfter->sample.position);
    else if (value == Said::done || position == Said::done || isThere)
        m_steps.goOn();
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
        m_steps.goOn();
    }
}

// What no shaft can have turned to decides; else what this one turned, by the speed at which it was seen to
// turn before and after.
EscJob::Said EscJob::positionSays() const
{
    if (!m_positionAfter)
        return Said::nothing;
    const auto isReachable = [&](const EscPositionAgreement::Sample &from) {
        const auto &[position, at] = m_positionAfter->sample;
        return m_encoder.guard.canReach(from.position, position, at - from.at);
    };
    if (!isReachable({m_steps.current().value, m_preset.sentAt.value_or(Instant())}))
        return Said::notDone;
    if (!m_positionBefore)
        return Said::nothing;
    if (!isReachable(m_positionBefore->sample))
        return Said::done;
    const bool fromPreset = hasTurnedFromPreset();
    const bool fromBefore = hasTurnedFrom(m_positionBefore->sample, m_positionBefore->speed);
    if (fromPreset == fromBefore)
        return Said::nothing;
    return fromPreset ? Said::done : Said::notDone;
}

// Whether the position is now where a shaft at that place turned to.
bool EscJob::hasTurnedFrom(const EscPositionAgreement::Sample &before, double speedThen) const
{
    const auto &[after, speed] = *m_positionAfter;
    const auto time = static_cast<double>((after.at - before.at).count());
    const double expected = (speedThen + speed) / 2 * time;
    const double doubt = std::abs(speed - speedThen) / 2 * time +
                         std::max(std::abs(speed), std::abs(speedThen)) * longestDelay + edgeOfStep;
    const auto turned = m_encoder.guard.turned(before.position, after.position);
    return std::abs(static_cast<double>(turned) - expected) <= doubt;
}

bool EscJob::hasTurnedFromPreset() const
{
    return m_positionAfter && m_preset.sentAt &&
           hasTurnedFrom({m_steps.current().value, *m_preset.sentAt},
                         m_positionBefore ? m_positionBefore->speed : m_positionAfter->speed);
}

// That it is the preset proves something only where it was another before. Where that is not known, a command
// with an answer is believed.
EscJob::Said EscJob::presetValueSays() const
{
    if (!m_preset.valueAfter)
        return Said::nothing;
    if (m_preset.valueAfter != m_steps.current().value)
        return Said::notDone;
    const bool hasChanged =
        m_preset.valueBefore ? m_preset.valueBefore != m_steps.current().value : !m_unanswered.has_value();
    return hasChanged ? Said::done : Said::nothing;
}

} // namespace codewheel
