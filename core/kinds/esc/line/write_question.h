// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_explain.h"

namespace codewheel {

// What a write about to be sent does, for the confirmation before it: names the command in words, its
// consequences, its cost and the exact bytes.
QString writeQuestion(const esc::Request &request, const esc::ExplainOptions &options);

} // namespace codewheel
