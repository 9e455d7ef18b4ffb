// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/computer.h"
#include "vocabulary/refusal.h"

namespace codewheel {

// "/dev/ttyUSB0" for "ttyUSB0"; a path stays as it is.
QString portPath(const QString &port);

// Whether both lead to the same port, like its by-id link and its name.
bool isSamePort(const QString &one, const QString &other);

// The group whose members may use the port: dialout on Debian. Its number if it has no name.
QString groupOf(const QString &path);

// Whether members of its group may use it.
bool mayGroupUse(const QString &path);

// Whether one of the groups that are there for serial ports may use it: joining another one, such as that of
// disks, would give away more than the port.
bool isForGroup(const QString &path);

// The command that lets the user use it: for good by its group, or else until it is unplugged.
QString rightsCommand(const QString &path);

// What the system's error number (errno) means for a serial port: not there, no rights, in use; linkFailed
// for all others.
RefusalCode portRefusalOf(int errorNumber);

// The refusal with everything its sentence needs. `errorText` is the system's.
Refusal portRefusal(RefusalCode id, const QString &path, const QString &errorText);

// Why the user cannot open this port, as far as can be told without opening it; empty: no reason is known.
std::optional<Refusal> portHindrance(const QString &path);

// Why it must not be opened: as above, or another program has it open (portInUse). A port has one rate for
// all who have it open, so that program would be disturbed, even where the system allows it.
std::optional<Refusal> openingHindrance(const QString &path, const Computer &computer = Computer());

// A setting that no serial port has (lineSettingWrong).
Refusal lineSettingRefusal(const QString &setting);

} // namespace codewheel
