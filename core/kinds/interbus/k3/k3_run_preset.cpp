// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a preset was carried out, and why not.
#include "kinds/interbus/k3/k3_run.h"

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
    switch (m_encoder.preset.says()) {
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

void K3Run::noteNotSet(RefusalId why, std::vector<RefusalArgument> arguments, Word in)
{
    if (m_notSet)
        return;
    if (m_reading.position)
        arguments.emplace_back(*m_reading.position);
    else
        arguments.emplace_back(in);
    m_notSet = {RefusalKind::device, why, std::move(arguments)};
}

void K3Run::presetFlagRead(std::int64_t flag)
{
    if (flag == 0 && m_notSet && m_notSet->id == RefusalId::presetNotTaken)
        m_notSet->id = RefusalId::presetUsedUp;
}

} // namespace codewheel
