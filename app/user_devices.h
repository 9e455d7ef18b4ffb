// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"

namespace codewheel {

// The folder of the user's own device descriptions, the same for the window and the command line:
// ~/.local/share/codewheel/devices. Need not exist.
QString userDeviceFolder();

// Adds the descriptions (*.json) of `folder`, except the file `except`, and returns what is wrong with those
// it left out. None replaces one that is already in the catalog.
std::vector<Catalog::Fault> addUserDevices(Catalog &catalog, const QString &folder,
                                           const QString &except = {});

// Adds one description file.
tl::expected<void, Catalog::Fault> addDeviceFile(Catalog &catalog, const QString &path);

} // namespace codewheel
