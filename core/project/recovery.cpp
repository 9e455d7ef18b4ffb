// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/recovery.h"

#include "project/file_access.h"
#include "project/project_file.h"
#include "project/project_json.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUuid>

#include <algorithm>
#include <cerrno>

namespace codewheel {
namespace {

const QString ending = QStringLiteral(".recovery");
const QString pathKey = QStringLiteral("path");
const QString timeKey = QStringLiteral("at");
const QString markKey = QStringLiteral("mark");

constexpr qint64 longestHeader = 1 << 16;

QString lockOf(const QString &file)
{
    return file + QStringLiteral(".lock");
}

void removeBoth(const QString &file)
{
    QFile::remove(file);
    QFile::remove(lockOf(file));
}

// One line before the project.
QByteArray header(const QString &path, const QDateTime &at, const QByteArray &mark)
{
    return QJsonDocument(QJsonObject{{pathKey, path},
                                     {timeKey, at.toUTC().toString(Qt::ISODateWithMs)},
                                     {markKey, QString::fromLatin1(mark.toHex())}})
               .toJson(QJsonDocument::Compact) +
           '\n';
}

} // namespace

Recovery::Recovery(QString folder)
    : m_folder(std::move(folder))
{}

Result<void> Recovery::begin()
{
    const QString name = QUuid::createUuid().toString(QUuid::Id128) + ending;
    const QString file = QDir(m_folder).filePath(name);
    QDir().mkpath(m_folder);
    FileLock lock(lockOf(file));
    if (!lock.isHeld())
        return refuse(RefusalKind::badInput, RefusalId::fileNotWritten,
                      {lockOf(file), qt_error_string(errno) + u'.'});
    m_file = file;
    m_lock = std::move(lock);
    return {};
}

Result<void> Recovery::keep(const Project &project, const QString &path, const QDateTime &at,
                            const QByteArray &mark)
{
    const QByteArray json = projectToJson(project);
    if (json == m_kept && path == m_keptFor)
        return {};
    if (m_file.isEmpty())
        if (auto begun = begin(); !begun)
            return begun;
    auto written = replaceFile(m_file, header(path, at, mark) + json, OldFile::goes);
    if (written) {
        m_kept = json;
        m_keptFor = path;
    }
    return written;
}

void Recovery::drop()
{
    if (!m_file.isEmpty())
        removeBoth(m_file);
    *this = Recovery(m_folder);
}

LeftProject::LeftProject(QString file, FileLock lock)
    : m_file(std::move(file))
    , m_lock(std::move(lock))
{
    QFile kept(m_file);
    if (!kept.open(QIODevice::ReadOnly))
        return;
    const QJsonObject told = QJsonDocument::fromJson(kept.readLine(longestHeader)).object();
    m_path = told[pathKey].toString();
    m_mark = QByteArray::fromHex(told[markKey].toString().toLatin1());
    m_at = QDateTime::fromString(told[timeKey].toString(), Qt::ISODateWithMs);
}

Result<Project> LeftProject::load() const
{
    return readWholeFile(m_file, largestProjectFile + longestHeader).and_then([&](const QByteArray &bytes) {
        return projectFromJson(bytes.sliced(bytes.indexOf('\n') + 1), m_file);
    });
}

void LeftProject::drop()
{
    removeBoth(m_file);
}

std::vector<LeftProject> leftProjects(const QString &folder)
{
    std::vector<LeftProject> left;
    const QDir files(folder);
    for (const QString &name : files.entryList({u'*' + ending}, QDir::Files)) {
        const QString file = files.filePath(name);
        if (FileLock lock(lockOf(file)); lock.isHeld() && QFile::exists(file)) // nobody dropped it
            left.push_back(LeftProject(file, std::move(lock)));
    }
    std::ranges::sort(left, std::greater(), &LeftProject::keptAt);
    return left;
}

} // namespace codewheel
