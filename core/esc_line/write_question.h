// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc/esc_explain.h"

namespace codewheel {

// What a write that is to be sent does, for the question before it: names the command in words, what follows
// from it, and the exact bytes.
QString writeQuestion(const esc::Request &request, const esc::ExplainOptions &options);

} // namespace codewheel
