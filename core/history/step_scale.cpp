// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/step_scale.h"

#include "catalog/device_description.h"
#include "catalog/protocol_rules.h"
#include "jobs/value_notes.h"
#include "jobs/values_to_write.h"
#include "vocabulary/rod_scale.h"

namespace codewheel {
namespace {

constexpr std::int64_t manySteps = 1'000'000;

// The newest of all values that the scale follows from.
struct Newest
{
    Instant at = Instant::min();
    Evidence evidence = Evidence::told;
};

StepScale stepScale(const EncoderSession &encoder, Newest &newest)
{
    return stepScale(encoder.device(), [&](Parameter parameter) -> std::optional<std::int64_t> {
        const auto known = encoder.known(parameter);
        if (!known)
            return {};
        if (known->at >= newest.at)
            newest = {known->at, known->evidence};
        return known->value.asNumber();
    });
}

} // namespace

StepScale stepScale(const DeviceDescription &device, const ValueOf &valueOf)
{
    StepScale scale{.isRod = isRod(device)};
    if (scale.isRod) {
        if (const auto rod = rodScale(valueOf(Parameter::measuringLength), valueOf(Parameter::rodLength)))
            scale.millimetresPerStep = rod->millimetres(manySteps) / manySteps;
    } else if (const auto shaft = speedScaleOf(device, valueOf)) {
        scale.stepsPerTurn = shaft->stepsPerTurn;
    }
    return scale;
}

StepScale stepScale(const EncoderSession &encoder)
{
    Newest newest;
    return stepScale(encoder, newest);
}

// What was only told, and is told or read otherwise, was never so; what was written was so until then.
void ScaleHistory::take(const EncoderSession &encoder, const std::function<Instant(Instant)> &sinceEpoch)
{
    Newest newest;
    const StepScale scale = stepScale(encoder, newest);
    if (!scale.isKnown())
        return;
    const bool isFirst = m_all.empty() || m_all.back().from < m_begin;
    const bool isCorrection = !isFirst && m_evidence == Evidence::told && newest.evidence != Evidence::echoed;
    if (isFirst)
        m_all.push_back({m_begin, scale});
    else if (isCorrection)
        m_all.back().scale = scale;
    else if (m_all.back().scale != scale)
        m_all.push_back({std::max(sinceEpoch(newest.at), m_all.back().from), scale});
    m_evidence = newest.evidence;
    m_known.resize(m_all.size());
    m_known.back() = valuesOf(allKnown(encoder));
}

std::vector<ValuesSince> ScaleHistory::known() const
{
    std::vector<ValuesSince> known;
    for (std::size_t i = 0; i < m_all.size(); ++i)
        known.push_back({m_all[i].from, m_known[i]});
    return known;
}

void ScaleHistory::beginAnew(Instant at)
{
    m_begin = at;
    m_evidence = Evidence::told;
}

} // namespace codewheel
