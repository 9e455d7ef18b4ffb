// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

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

// The act of a row, by the value of an enumeration, with what belongs to it.
TrainingAct actOf(std::span<const TrainingActRow> rows, std::size_t row,
                  const std::vector<RefusalArgument> &its);

// The key of an act; empty: it has none, as in messages of earlier versions.
QString keyOf(const TrainingAct &act);

// "Battery flat: yes.": what is so of a simulated encoder, or is not any more, by the key of its row.
TrainingAct conditionAct(const QString &act, const char *condition, bool isSo);
QString conditionText(const TrainingAct &act, const QString &name);
// Nothing: it is another act. `conditions` have a key and a text, which is translated in `context`.
template <typename Rows>
std::optional<QString> conditionText(const TrainingAct &act, const QString &its, const Rows &conditions,
                                     const char *context)
{
    constexpr std::size_t parts = 3;
    const bool isIts = act.size() == parts && keyOf(act) == its;
    const auto *row = isIts ? rowByKey(conditions, argumentText(act[1])) : nullptr;
    return row == nullptr
               ? std::nullopt
               : std::optional(conditionText(act, QCoreApplication::translate(context, row->text)));
}

// Everything simulated began anew.
TrainingAct startedAfresh();

// In the user's language. A text of an earlier version, or what a newer one wrote, is shown as it is.
QString trainingActText(const TrainingAct &act);

} // namespace codewheel
