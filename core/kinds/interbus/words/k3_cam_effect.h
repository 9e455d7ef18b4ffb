// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"

#include <QString>

namespace codewheel::k3 {

// What the word does in cam mode: "sets the start of cam 0 to 0".
QString camModeEffect(Word word);

} // namespace codewheel::k3
