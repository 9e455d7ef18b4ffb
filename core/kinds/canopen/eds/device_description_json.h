// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/device_file.h"

#include <QJsonObject>

namespace codewheel::canopen {

// 1000h of the file; empty: it does not say, or says 0.
std::optional<std::uint32_t> deviceTypeIn(const DeviceFile &file);
// A key for its description, of vendor and product: "rotor-works-rotor-12".
QString descriptionKeyOf(const FileIdentity &identity);

// The description of an encoder (docs/device-descriptions.md) as a device file has it: the parameters of
// `generic`, one of the descriptions of CiA 406, that it has objects for, with its types, limits and
// defaults, and the other objects that are numbers, read only and as details: what the maker does when they
// are written, no file says. `from`: the name of the file.
QJsonObject descriptionOf(const DeviceFile &file, QJsonObject generic, const QString &key,
                          const QString &from);

} // namespace codewheel::canopen
