// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/step_text.h"

#include "vocabulary/hex.h"

namespace codewheel {

QString sentText(const Step &step)
{
    return step.line.isEmpty() ? hexWord(step.out) : QString::fromLatin1(step.line);
}

} // namespace codewheel
