// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/subcommand.h"
#include "encoder/place.h"
#include "project/project.h"

#include <optional>

namespace codewheel {

// The project that --project names; nothing where it names none.
Checked<std::optional<Project>> projectNamed(const Arguments &arguments);

// Refused, with the file as it is, where another program has changed it since the project was read that
// `mark` is of (projectMark()).
Checked<void> saveUnlessChanged(const Project &project, const QString &file, const QByteArray &mark);

// Takes the encoders of the bus, for this call, for those of the project: names them as it does where the bus
// has the same device at the same place (ProjectPlaces), tells where it has not, and counts their EEPROM
// writes as of its places and labels.
void useProject(const Call &call, const Project &project, const QString &file);

// Where the project has the device of this station: one, and only while the bus is as configured.
Checked<Place> placeOfStation(const Call &call, const Project &project, const QString &station);

// The place that PLACE means: a device number, the station name of a device of the project, or the address of
// an encoder on the serial line; a station of two hexadecimal digits goes before an address. Refused where
// the project has another device at that place; a station name also where the bus differs from the project at
// all, since a device may stand elsewhere then.
Checked<QString> placeMeant(const Call &call, const QString &typed);

} // namespace codewheel
