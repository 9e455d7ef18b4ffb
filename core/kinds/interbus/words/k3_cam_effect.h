// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

#include <QStringList>

namespace codewheel::k3 {

// The arguments of a refusal of an OUT word, and behind the word what it does in cam mode: "sets the start of
// cam 0 to 0". Without a word, what a preset does.
QStringList camWordTexts(const std::vector<RefusalArgument> &arguments);

} // namespace codewheel::k3
