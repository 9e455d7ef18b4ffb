// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "vocabulary/refusal.h"

#include <json/value.h>
#include <span>

namespace codewheel {

// A project as text, in the form described in docs/project-files.md. Disk access is in
// project/project_file.h.

inline constexpr std::size_t mostProjectSequences = 1'000;

// The same project always gives the same bytes.
QByteArray projectToJson(const Project &project);

// Turns version n of the format into version n + 1, where n is its place in the list, from 1.
using MigrationStep = void (*)(Json::Value &root);
// One step for each version before the newest.
std::span<const MigrationStep> projectMigrations();

// Rejects a file that breaks a rule as a whole: projectFileBroken with line, key and reason; projectFileNewer
// for a version beyond the newest. An older one is migrated by `steps`. `name` is the file's, for the
// sentence.
Result<Project> projectFromJson(const QByteArray &json, const QString &name,
                                std::span<const MigrationStep> steps = projectMigrations());

} // namespace codewheel
