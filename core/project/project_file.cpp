// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/project_file.h"

#include "project/file_access.h"
#include "project/project_json.h"

#include <QFileInfo>

namespace codewheel {
namespace {

// Through a symbolic link to the file itself, so that the link stays one.
QString fileItself(const QString &path)
{
    const QString target = QFileInfo(path).canonicalFilePath();
    return target.isEmpty() ? path : target;
}

Result<Project> projectIn(const QByteArray &json, const QString &path)
{
    if (json.size() > largestProjectFile)
        return refuseTooLarge(path, json.size(), largestProjectFile);
    return projectFromJson(json, path);
}

} // namespace

Result<Project> loadProject(const QString &path)
{
    return readWholeFile(path, largestProjectFile).and_then([&](const QByteArray &json) {
        return projectFromJson(json, path);
    });
}

Result<void> saveProject(const Project &project, const QString &path)
{
    const QByteArray json = projectToJson(project);
    if (auto readable = projectIn(json, path); !readable)
        return tl::unexpected(readable.error());

    const QString file = fileItself(path);
    const auto before = readWholeFile(file, largestProjectFile);
    if (before && *before == json)
        return {};
    const bool isGood = before && projectFromJson(*before, file);
    const bool keep = isGood || !QFileInfo::exists(backupPath(file));
    return replaceFile(file, json, keep ? OldFile::isKeptAsBackup : OldFile::goes);
}

} // namespace codewheel
