// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/k3/k3_step.h"
#include "kinds/interbus/words/k3_explain.h"

#include <optional>

namespace codewheel {

// The value a step gives the encoder, if it is that of a parameter named by the description.
std::optional<ParameterValue> valueGivenBy(const K3Step &step);

// A word that was in OUT, unanswered, when its job was cancelled: the encoder may still take it. Part of
// K3Run.
class K3LateAnswer
{
public:
    enum class Fate : std::uint8_t { open, taken, refused };

    K3LateAnswer(const K3Step &step, Instant since)
        : m_step(step)
        , m_since(since)
    {}

    const K3Step &step() const { return m_step; }
    bool isAboutCams() const { return m_step.kind == StepKind::camParameter; }

    // What IN says about it so far.
    Fate fate(Word in, k3::Dialect dialect) const;
    // Whether the encoder may still be processing it, so that nothing else may be sent.
    bool isAwaited(Word in, Instant now, Instant timeOut) const;

private:
    K3Step m_step;
    Instant m_since;
};

} // namespace codewheel
