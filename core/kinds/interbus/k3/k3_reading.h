// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_explain.h"
#include "vocabulary/reading.h"

namespace codewheel {

// What it takes to read an IN word of a K3 encoder.
struct K3View
{
    k3::Dialect dialect = k3::Dialect::generic;
    bool mayHaveModes = false; // then a position is a position only in Mode::position
    std::optional<Mode> mode;
    std::optional<PositionCoding> coding; // empty: only the raw word is known
    std::optional<unsigned> camProgram{}; // in cam mode
};

EncoderState stateOf(Word in, k3::Dialect dialect) noexcept;

// IN = 1 0 0 (with Baumer 1 0 x) with a number that is not 0: "disturbance".
bool isErrorAnswer(Word in, k3::Dialect dialect) noexcept;

Reading decodeReading(Word in, Instant at, const K3View &view) noexcept;

} // namespace codewheel
