// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/kinds/canopen/dictionary/dictionary_view.h"

namespace codewheel {

class CanopenAtWork;

// What is wanted is what a transfer would write. A file that is not where the project says is looked for
// beside the project.
PlannedObjects plannedObjectsOn(const CanopenAtWork &bus);

} // namespace codewheel
