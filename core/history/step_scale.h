// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/values_since.h"
#include "jobs/position_scale.h"
#include "vocabulary/known.h"

#include <optional>
#include <vector>

namespace codewheel {

class EncoderSession;

// What a step of an encoder is, as far as that is known.
struct StepScale
{
    bool isRod = false;
    std::optional<double> stepsPerTurn{};
    std::optional<double> millimetresPerStep{}; // of a rod

    bool isKnown() const { return stepsPerTurn || millimetresPerStep; }
    friend bool operator==(const StepScale &, const StepScale &) = default;
};

StepScale stepScale(const DeviceDescription &device, const ValueOf &valueOf);
StepScale stepScale(const EncoderSession &encoder);

// What a step was since a moment.
struct ScaleSince
{
    Instant from{};
    StepScale scale{};

    friend bool operator==(const ScaleSince &, const ScaleSince &) = default;
};

// What the steps of an encoder were over the time, as it became known. What is known first was so before,
// too.
class ScaleHistory
{
public:
    const std::vector<ScaleSince> &all() const { return m_all; } // oldest first
    // With all that was known of the encoder at the end of the time of each.
    std::vector<ValuesSince> known() const;
    // As it is known of the encoder now; `sinceEpoch`: from the clock of its bus.
    void take(const EncoderSession &encoder, const std::function<Instant(Instant)> &sinceEpoch);
    // From here on it is another encoder, or one of which nothing is known as yet.
    void beginAnew(Instant at);

private:
    std::vector<ScaleSince> m_all;
    std::vector<ParameterValues> m_known; // at each of these
    Evidence m_evidence = Evidence::told; // of the newest
    Instant m_begin = Instant::min();     // of what is known now
};

} // namespace codewheel
