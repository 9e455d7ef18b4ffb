// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/answer.h"

namespace codewheel {

class Catalog;

// What the key on a label says, and which devices it may belong to.
Checked<Answer> labelAnswer(const Catalog &catalog, const QString &typed);

// Whether the description file at `path` is valid. What the user's folder already has of it is no reason to
// reject it.
Answer checkAnswer(const QString &path);

} // namespace codewheel
