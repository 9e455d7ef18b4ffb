// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_explain.h"

// The parts of explain(), one for each direction and one for FRABA's cams.
namespace codewheel::k3 {

Explanation explainOut(Word word, const ExplainContext &context) noexcept;
Explanation explainIn(Word word, const ExplainContext &context) noexcept;

// What cam mode makes of an OUT word that sets something. Precondition: isCamParameter(word).
Meaning camParameter(Word word) noexcept;
// 202000xx, whatever the mode.
Meaning camReadOutRequest(Word word) noexcept;
// The answer A0000000 + value beside 202000xx.
Meaning camReadOutValue(Word request, Word value) noexcept;
// An acknowledged cam word: IN shows OUT with D31 D30 = 11, so D30 of OUT is lost.
Explanation camConfirmations(Word in, std::optional<Word> out) noexcept;

// Whether the word may belong to this mode, as far as is known.
constexpr bool mayBeIn(Mode mode, const ExplainContext &context) noexcept
{
    return context.dialect == Dialect::baumer ? mode == Mode::position : context.mode.value_or(mode) == mode;
}

// Velocity mode understands the same OUT words as position mode.
constexpr bool mayBeOutsideCamMode(const ExplainContext &context) noexcept
{
    return mayBeIn(Mode::position, context) || mayBeIn(Mode::velocity, context);
}

} // namespace codewheel::k3
