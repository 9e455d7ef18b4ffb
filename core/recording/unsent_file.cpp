// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/unsent_file.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QSysInfo>
#include <QUrl>

namespace codewheel {
namespace {

constexpr qsizetype hostPartLength = 24; // a name in PostgreSQL has 63 bytes at most

const QString suffix = QStringLiteral(".cwrec");

QString folderOf(const QString &folder, const ServerAddress &server)
{
    const QString place = server.place().section(QStringLiteral("://"), 1);
    return QDir(folder).filePath(QString::fromLatin1(QUrl::toPercentEncoding(place, "@:")));
}

// In the order of their names recordings are in the order of their begin. Several may begin at the same time.
QString newRecordingName(Instant begun)
{
    static const QRegularExpression others(QStringLiteral("[^a-z0-9]+"));
    const QString host = QSysInfo::machineHostName().toLower().replace(others, QStringLiteral("_"));
    const auto at = QDateTime::fromMSecsSinceEpoch(
        std::chrono::duration_cast<std::chrono::milliseconds>(begun).count(), Qt::UTC);
    return QStringLiteral("codewheel_%1_%2_%3")
        .arg(at.toString(QStringLiteral("yyyyMMdd_HHmmss")), host.left(hostPartLength),
             QString::number(QRandomGenerator::system()->generate(), 16).rightJustified(8, u'0'));
}

} // namespace

QString UnsentFile::usualFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           QStringLiteral("/codewheel/unsent");
}

UnsentFile::UnsentFile(const QString &path)
    : m_path(path)
    , m_lock(path + QStringLiteral(".lock"))
{
    m_lock.setStaleLockTime(0); // a recording may last for weeks
}

std::unique_ptr<UnsentFile> UnsentFile::forNew(const QString &folder, const ServerAddress &server,
                                               Instant begun)
{
    const QString its = folderOf(folder, server);
    QDir().mkpath(its);
    std::unique_ptr<UnsentFile> made(new UnsentFile(QDir(its).filePath(newRecordingName(begun) + suffix)));
    return made->isLocked() ? std::move(made) : nullptr;
}

std::unique_ptr<UnsentFile> UnsentFile::leftOver(const QString &folder, const ServerAddress &server,
                                                 const QStringList &except)
{
    const QDir its(folderOf(folder, server));
    for (const QString &name : its.entryList({u'*' + suffix}, QDir::Files, QDir::Name)) {
        if (except.contains(its.filePath(name)))
            continue;
        std::unique_ptr<UnsentFile> found(new UnsentFile(its.filePath(name)));
        if (found->isLocked() && QFileInfo::exists(found->path())) // its program may just have sent it
            return found;
    }
    return nullptr;
}

QString UnsentFile::recording() const
{
    return QFileInfo(m_path).completeBaseName();
}

void UnsentFile::remove()
{
    QFile::remove(m_path);
}

} // namespace codewheel
