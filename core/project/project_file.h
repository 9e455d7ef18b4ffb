// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "vocabulary/refusal.h"

namespace codewheel {

// Far more than any project of 512 devices; a file of this size is read within a second.
inline constexpr qint64 largestProjectFile = 8'000'000; // bytes

// Reads a project file: fileNotReadable, fileTooLarge (nothing of it is read), projectFileBroken,
// projectFileNewer.
Result<Project> loadProject(const QString &path);

// Replaces or creates the file: at every moment it is either the old one or the new one as a whole, even if
// the program or the machine stops. The old one is kept as NAME~, unless it is not a project and there is
// already a NAME~. Nothing is done if the file already holds the project. Refused, with the file as it was:
// fileNotWritten, also if it could not be opened again.
Result<void> saveProject(const Project &project, const QString &path);

// The same, unless something would be lost that another program has saved there since: fileChanged, if the
// file holds something other than the project that `known` is the mark of. One program saves at a time, so
// nothing comes between checking and replacing.
Result<void> saveProjectOver(const QByteArray &known, const Project &project, const QString &path);

// A short mark of what a project would have in its file: the same for the same project.
QByteArray projectMark(const Project &project);

// Whether saving to `path` would lose what another program has saved there: the file holds something other
// than the project that `known` is the mark of. If there is no file, nothing can be lost.
bool holdsAnother(const QString &path, const QByteArray &known);

} // namespace codewheel
