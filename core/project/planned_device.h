// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "project/project.h"

namespace codewheel {

// What a device of the plan is: the description it is named by, or that of its device code if its make is not
// known. The resolution on its label takes precedence. Empty: there is no description.
std::optional<DeviceDescription> plannedDescription(const ProjectDevice &device, const Catalog &catalog);

} // namespace codewheel
