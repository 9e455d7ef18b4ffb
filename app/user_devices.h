// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"

namespace codewheel {

// The folder of the user's own device descriptions, the same for the window and the command line:
// ~/.local/share/codewheel/devices. Need not exist.
QString userDeviceFolder();

// Adds the descriptions (*.json) of `folder`, but that in the file `except`, and tells what is wrong with
// those that are left out. None takes the place of one that is in the catalog.
std::vector<Catalog::Fault> addUserDevices(Catalog &catalog, const QString &folder,
                                           const QString &except = {});

// Adds one description file.
tl::expected<void, Catalog::Fault> addDeviceFile(Catalog &catalog, const QString &path);

} // namespace codewheel
