// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/fault_plan.h"

namespace codewheel {

// The fault plan in the file at `path`: fileNotReadable, fileTooLarge, or what faultPlanFromJson() refuses.
Result<FaultPlan> loadFaultPlan(const QString &path, const std::vector<TrainingPlace> &ring);

} // namespace codewheel
