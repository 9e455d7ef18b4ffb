// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a preset was carried out, and why not.
#include "kinds/interbus/k3/k3_run.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

// What would have to be known to tell where the position goes.
std::optional<Parameter> missingForPreset(const DeviceDescription &device, const K3Knowledge &knowledge)
{
    for (const Parameter parameter : {Parameter::preset, Parameter::coding, Parameter::offset,
                                      Parameter::steps, Parameter::revolutions, Parameter::measuringRange})
        if (device.find(parameter) != nullptr && !knowledge.value(parameter))
            return parameter;
    return std::nullopt;
}

} // namespace

// The current step is the one in which the new position shows.
bool K3Run::showsPreset() const
{
    const OwnKind kind = m_steps.current().kind;
    return kind == StepKind::initialisePreset ||
           (kind == StepKind::toNormal && follows(StepKind::manufacturerPreset));
}

// 40000000h among words of the user stands until it acts.
bool K3Run::presetIsOpen(Word in, Instant now) const
{
    if (m_steps.current().standsUntilItActs)
        return k3::isOperation(in) && !m_encoder.preset.hasActed(now, m_encoder.timing);
    return showsPreset() && !m_cancelled && !m_encoder.preset.isOver(now, m_encoder.timing);
}

void K3Run::judgePreset(Word in)
{
    m_account.outcome.positionAfter = m_reading.position;
    const K3PresetProof::Said said = m_encoder.preset.says();
    if (m_mayBeInRpm && m_encoder.preset.target() && said != K3PresetProof::Said::done) {
        noteMayBeSpeed(in);
        return;
    }
    if (m_mayBeInRpm && said == K3PresetProof::Said::done &&
        !m_encoder.preset.hasArrived()) { // it showed that number before, perhaps as a speed
        m_account.outcome.positionBefore.reset();
        m_account.outcome.positionAfter.reset();
    }
    switch (said) {
    case K3PresetProof::Said::done:
        return;
    case K3PresetProof::Said::notDone:
        noteNotSet(RefusalId::presetNotTaken, {m_encoder.preset.target()->position}, in);
        if (m_encoder.device.quirks.presetNeedsRearming)
            m_encoder.plan.appendRead(m_steps.all, Parameter::presetFlag);
        return;
    case K3PresetProof::Said::nothing:
        break;
    }
    const auto missing = missingForPreset(m_encoder.device, m_encoder.knowledge);
    if (!m_encoder.preset.target() && missing)
        noteNotSet(RefusalId::presetNotKnownWithout, {*missing}, in);
    else
        noteNotSet(RefusalId::presetNotKnown, {}, in);
}

void K3Run::noteNotSet(RefusalCode why, std::vector<RefusalArgument> arguments, Word in)
{
    if (m_notSet)
        return;
    if (m_reading.position)
        arguments.emplace_back(*m_reading.position);
    else
        arguments.emplace_back(in);
    m_notSet = {RefusalKind::device, why, std::move(arguments)};
}

// Velocity mode takes a preset, too, and does not show it. Whether it did is told by the flag.
void K3Run::noteMayBeSpeed(Word in)
{
    Outcome &outcome = m_account.outcome;
    m_mayBeSpeed = Shown{std::exchange(outcome.positionBefore, {}), std::exchange(outcome.positionAfter, {})};
    m_notSet = {RefusalKind::device, RefusalId::presetNotKnown, {m_encoder.preset.target()->position, in}};
    m_encoder.plan.appendRead(m_steps.all, Parameter::presetFlag);
}

// A preset that was programmed and is used up now was carried out, whatever the position shows.
void K3Run::presetFlagRead(std::int64_t flag)
{
    const bool isUsedUp = flag == 0;
    const bool isNotTaken = m_notSet && m_notSet->id == RefusalId::presetNotTaken;
    if (isUsedUp && isNotTaken && m_wasArmed)
        m_notSet = {RefusalKind::device, RefusalId::presetNotKnown, {m_notSet->arguments.back()}};
    else if (isUsedUp && isNotTaken)
        m_notSet->id = RefusalId::presetUsedUp;
    else if (!isUsedUp && m_mayBeSpeed)
        presetWasNotTaken();
}

void K3Run::presetWasNotTaken()
{
    m_notSet = {RefusalKind::device, RefusalId::presetNotTaken, m_notSet->arguments};
    if (m_mayBeSpeed->after)
        m_notSet->arguments.back() = *m_mayBeSpeed->after;
    m_account.outcome.positionBefore = m_mayBeSpeed->before;
    m_account.outcome.positionAfter = m_mayBeSpeed->after;
    m_mayBeSpeed.reset();
}

// Run that is answered by 00000000 does not prove what the encoder has now.
void K3Run::readPresetAgain()
{
    const auto sets = std::find_if(m_steps.rest(), m_steps.all.end(),
                                   [](const K3Step &step) { return setsPosition(step); });
    if (sets == m_steps.all.end() || m_encoder.knowledge.value(Parameter::preset))
        return;
    K3Steps read;
    m_encoder.plan.appendRead(read, Parameter::preset);
    m_steps.all.insert(sets, read.begin(), read.end());
}

} // namespace codewheel
