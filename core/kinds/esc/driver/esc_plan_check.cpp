// SPDX-License-Identifier: GPL-3.0-or-later
// What of a job for an encoder on a serial line is refused before anything is sent.
#include "jobs/job_check.h"
#include "kinds/esc/driver/esc_plan.h"
#include "kinds/esc/driver/esc_values.h"
#include "kinds/esc/protocol/esc_forms.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// What the encoder will have once the job is done, as far as can be told: a new scaling changes a measuring
// range that is not given.
ParameterValues afterwards(ParameterValues known, const ParameterValues &wanted)
{
    const bool rescales = std::ranges::any_of(
        wanted, [](const ParameterValue &value) { return isEscScaling(value.parameter); });
    if (rescales)
        std::erase_if(known, [](const ParameterValue &value) { return isBoundToEscFactor(value.parameter); });
    for (const ParameterValues &values : {escSetAlong(wanted, known), wanted})
        for (const ParameterValue &value : values)
            replaceValue(known, value);
    return known;
}

// Steps and measuring range take effect through the one factor computed for them.
Result<void> checkScaling(const ParameterValues &wanted, const ParameterValues &known)
{
    const auto steps = valueOf(wanted, Parameter::steps);
    const auto range = valueOf(wanted, Parameter::measuringRange);
    if (!steps || !range || valueOf(wanted, Parameter::scalingFactor))
        return {};
    const std::int64_t turns = escTurnsOf(wanted, known);
    const std::int64_t least = *range / turns;
    const std::int64_t most = (*range + turns - 1) / turns;
    if (*steps == least || *steps == most)
        return {};
    return refuse(
        RefusalKind::badInput, RefusalId::valueNotAllowed,
        {Parameter::steps, numberText(*steps),
         sentence(QCoreApplication::translate("EscPlan", "%1, which goes with a measuring range of %2"),
                  {numberText(most), numberText(*range)})});
}

} // namespace

Result<void> EscPlan::check(const Job &job) const
{
    if (auto checked =
            checkJob(m_device, job, KindData(EscValueOptions{.fractionBits = m_settings.fractionBits}));
        !checked)
        return checked;
    if (const auto *write = std::get_if<WriteParameters>(&job))
        return checkWrite(*write);
    if (const auto *preset = std::get_if<SetPreset>(&job))
        return checkPreset(*preset);
    if (std::holds_alternative<ReadParameters>(job))
        return {};
    return refuse(RefusalKind::notSupported, RefusalId::jobNotSupported, {m_device.fullName()});
}

Result<void> EscPlan::checkWrite(const WriteParameters &job) const
{
    if (auto checked = checkScaling(job.values, m_known); !checked)
        return checked;
    const ParameterValues known = afterwards(m_known, job.values);
    for (const ParameterValue &value : job.values) {
        const ParameterDescription narrowed =
            escNarrowed(m_device, value.parameter, known, m_settings.fractionBits);
        if (auto checked = checkRange(narrowed, value.value); !checked)
            return checked;
        if (value.parameter == Parameter::lineAddress)
            if (auto checked = checkAddress({static_cast<std::uint8_t>(value.value.number())}); !checked)
                return checked;
    }
    return {};
}

Result<void> EscPlan::checkPreset(const SetPreset &job) const
{
    if (!m_device.find(Parameter::preset))
        return refuse(RefusalKind::notSupported, RefusalId::presetNotSupported, {m_device.fullName()});
    return checkRange(escNarrowed(m_device, Parameter::preset, m_known), *job.value);
}

// The encoder may move to either reading of the two digits, and whoever is there would answer along with it.
Result<void> EscPlan::checkAddress(EscLineAddress wanted) const
{
    for (const EscLineAddress reading : escReadingsOf(wanted))
        if (const auto taken = m_taken.find(reading); taken != m_taken.end() && reading != m_address)
            return refuse(RefusalKind::badInput, RefusalId::lineAddressTaken,
                          {reading.shown(), taken->second});
    return {};
}

} // namespace codewheel
