// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_explain.h"

#include "kinds/interbus/words/k3_explain_parts.h"

namespace codewheel::k3 {

Explanation explain(Word word, const ExplainContext &context) noexcept
{
    return context.direction == WordDirection::out ? explainOut(word, context) : explainIn(word, context);
}

} // namespace codewheel::k3
