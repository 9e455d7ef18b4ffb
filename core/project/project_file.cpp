// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/project_file.h"

#include "project/file_access.h"
#include "project/folder_lock.h"
#include "project/project_json.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

namespace codewheel {
namespace {

// Follows a symbolic link to the file itself, so that the link stays a link.
QString fileItself(const QString &path)
{
    const QString target = QFileInfo(path).canonicalFilePath();
    return target.isEmpty() ? path : target;
}

struct ProjectFile
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ProjectFile)
};

// Why it could not be opened again; empty if it could.
QString faultOf(const QByteArray &json, const QString &path)
{
    if (json.size() > largestProjectFile)
        return sentence(ProjectFile::tr("It would have %1 MB; the largest that can be opened has %2 MB."),
                        {inMegabytes(json.size()), inMegabytes(largestProjectFile)});
    const auto project = projectFromJson(json, path);
    if (project)
        return {};
    const QStringList parts = argumentTexts(project.error().arguments); // file, line, key, reason
    return sentence(ProjectFile::tr("It could not be opened again. %3: %4"), parts);
}

// What programs left beside the file that ended between making a backup and naming it: NAME.PID~, unless it
// holds more than the file itself or its backup.
void dropLeftBackups(const QString &file)
{
    const QFileInfo info(file);
    const QRegularExpression left(
        QStringLiteral("^%1\\.[0-9]+~$").arg(QRegularExpression::escape(info.fileName())));
    const QStringList names = info.absoluteDir().entryList(QDir::Files | QDir::Hidden).filter(left);
    for (const QString &name : names) {
        const QString path = info.absoluteDir().filePath(name);
        const auto held = readWholeFile(path, largestProjectFile);
        if (held && (held == readWholeFile(file, largestProjectFile) ||
                     held == readWholeFile(backupPath(file), largestProjectFile)))
            QFile::remove(path);
    }
}

// `known`: the mark of what the file may hold; null: anything.
Result<void> save(const Project &project, const QString &path, const QByteArray *known)
{
    const QByteArray json = projectToJson(project);
    if (const QString fault = faultOf(json, path); !fault.isEmpty())
        return refuse(RefusalKind::badInput, RefusalId::fileNotWritten, {path, fault});

    const QString file = fileItself(path);
    const FolderLock lock(file);
    if (lock.isRefused())
        return refuse(RefusalKind::busy, RefusalId::fileNotWritten,
                      {path, ProjectFile::tr("Another program has locked its folder.")});
    if (known != nullptr && holdsAnother(file, *known))
        return refuse(RefusalKind::busy, RefusalId::fileChanged, {path});
    dropLeftBackups(file);
    const auto before = readWholeFile(file, largestProjectFile);
    if (before && *before == json)
        return {};
    const bool isGood = before && projectFromJson(*before, file);
    const bool keep = isGood || !QFileInfo::exists(backupPath(file));
    return replaceFile(file, json, keep ? OldFile::isKeptAsBackup : OldFile::goes);
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
    return save(project, path, nullptr);
}

Result<void> saveProjectOver(const QByteArray &known, const Project &project, const QString &path)
{
    return save(project, path, &known);
}

QByteArray projectMark(const Project &project)
{
    return QCryptographicHash::hash(projectToJson(project), QCryptographicHash::Sha256);
}

bool holdsAnother(const QString &path, const QByteArray &known)
{
    if (!QFileInfo::exists(path))
        return false;
    const auto held = loadProject(path);
    return !held || projectMark(*held) != known;
}

} // namespace codewheel
