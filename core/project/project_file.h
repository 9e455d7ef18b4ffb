// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"
#include "project/project.h"

namespace codewheel {

// Far more than any project of 512 devices; a file of this size is read within a second.
inline constexpr qint64 largestProjectFile = 8'000'000; // bytes

// Reads a project file: fileNotReadable, fileTooLarge (nothing of it is read), projectFileBroken,
// projectFileNewer.
Result<Project> loadProject(const QString &path);

// Replaces the file, or makes it: at each moment it is the old one or the new one as a whole, also when the
// program or the machine stops. The old one is kept as NAME~, unless it is no project and there is a NAME~
// already. Nothing is done where the file holds the project already. Refused, with the file as it was:
// fileNotWritten, also where it could not be opened again.
Result<void> saveProject(const Project &project, const QString &path);

// The same, where nothing would be lost that another program has saved there since: fileChanged, where the
// file holds something else than the project that `known` is the mark of. One program saves at a time, so
// nothing comes between looking and replacing.
Result<void> saveProjectOver(const QByteArray &known, const Project &project, const QString &path);

// What a project would have in its file, in short: the same for the same project.
QByteArray projectMark(const Project &project);

// Whether saving to `path` would lose what another program has saved there: the file holds something else
// than the project that `known` is the mark of. Where there is no file, nothing can be lost.
bool holdsAnother(const QString &path, const QByteArray &known);

} // namespace codewheel
