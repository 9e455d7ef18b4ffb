// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

#include <optional>
#include <span>

namespace codewheel {

// What a trainer or a fault plan did to a simulated bus: its key, and what belongs to it. Messages store it,
// and it is told in the language of whoever reads them.
using TrainingAct = std::vector<RefusalArgument>;

// A sentence; %1, %2, ... are what belongs to the act.
struct TrainingActRow
{
    const char *key;
    const char *text;
    int decimals = 1; // of a number that is not whole
};

// The sentence, translated in `context`; nothing: no row has its key.
std::optional<QString> sentenceOf(const TrainingAct &act, std::span<const TrainingActRow> rows,
                                  const char *context);

// The key of an act; empty: it has none, as in messages of earlier versions.
QString keyOf(const TrainingAct &act);

// Everything simulated began anew.
TrainingAct startedAfresh();

// In the user's language. A text of an earlier version, or what a newer one wrote, is shown as it is.
QString trainingActText(const TrainingAct &act);

} // namespace codewheel
