// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_late_answer.h"

#include "kinds/interbus/k3/k3_reading.h"

namespace codewheel {

std::optional<ParameterValue> valueGivenBy(const K3Step &step)
{
    if (!step.parameter())
        return std::nullopt;
    if (step.kind == StepKind::parameter)
        return ParameterValue{*step.parameter(), step.value};
    if (step.kind == StepKind::word)
        return ParameterValue{*step.parameter(), k3::data(step.out)};
    return std::nullopt;
}

K3LateAnswer::Fate K3LateAnswer::fate(Word in, k3::Dialect dialect) const
{
    if (!isAboutCams())
        return k3::isConfirmation(in) && k3::number(in) == k3::number(m_step.out) ? Fate::taken : Fate::open;
    if (in == (m_step.out | k3::confirmation))
        return Fate::taken;
    return isErrorAnswer(in, dialect) ? Fate::refused : Fate::open; // instead of the acknowledgement
}

// Baumer: the new data beside the previous number. FRABA shows nothing of a cam word before it is
// acknowledged.
bool K3LateAnswer::isAwaited(Word in, Instant now, Instant timeOut) const
{
    const bool isProcessing = k3::isConfirmation(in) && k3::data(in) == k3::data(m_step.out);
    return (isAboutCams() || isProcessing) && now - m_since < timeOut;
}

} // namespace codewheel
