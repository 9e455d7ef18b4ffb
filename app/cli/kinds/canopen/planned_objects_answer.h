// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/canopen/object_argument.h"

namespace codewheel {

// For `od PLACE`: the objects of the node as they are known without asking it, from the file that the project
// has of the encoder, or else from its description. Opens nothing.
Checked<Answer> answerOfPlannedObjects(const Call &call, const NodeMeant &where);

} // namespace codewheel
