// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/file_access.h"

#include "project/file_replacement.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <cstdio>
#include <unistd.h>

namespace codewheel {
namespace {

constexpr qint64 megabyte = 1'000'000;

tl::unexpected<Refusal> notReadable(const QString &path, const QString &reason)
{
    return refuse(RefusalKind::badInput, RefusalId::fileNotReadable, {path, reason});
}

tl::unexpected<Refusal> notWritten(const QString &path, const QString &reason)
{
    return refuse(RefusalKind::link, RefusalId::fileNotWritten, {path, reason});
}

QString noFile()
{
    return QCoreApplication::translate("codewheel::FileAccess", "It is not a file.");
}

std::int64_t megabytes(qint64 bytes)
{
    return (bytes + megabyte - 1) / megabyte;
}

tl::unexpected<Refusal> tooLarge(const QString &path, qint64 size, qint64 allowed)
{
    return refuse(RefusalKind::badInput, RefusalId::fileTooLarge,
                  {path, megabytes(size), megabytes(allowed)});
}

QString systemReason()
{
    return qt_error_string(errno);
}

// A second name for what is at `from`; a copy where the file system does not support that.
bool linkOrCopy(const QString &from, const QString &to)
{
    return ::link(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) == 0 ||
           QFile::copy(from, to);
}

bool rename(const QString &from, const QString &to)
{
    return std::rename(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) == 0;
}

// The old file stays under its name, and gets a second one beside it.
bool keepBackup(const QString &path)
{
    const QString name = QStringLiteral("%1.%2~").arg(path).arg(::getpid());
    QFile::remove(name); // left by a program that was killed here
    if (!linkOrCopy(path, name))
        return false;
    const bool isKept = rename(name, backupPath(path));
    QFile::remove(name); // it remains if both are already the same file
    return isKept;
}

} // namespace

QString backupPath(const QString &path)
{
    return path + u'~';
}

QString inMegabytes(qint64 bytes)
{
    return argumentText(megabytes(bytes));
}

QString whyNotWritten(const Refusal &refusal)
{
    QString reason = argumentTexts(refusal.arguments).value(1);
    if (reason.endsWith(u'.'))
        reason.chop(1);
    return reason;
}

Result<QByteArray> readWholeFile(const QString &path, qint64 largest)
{
    const QFileInfo info(path);
    if (!info.exists())
        return notReadable(path, qt_error_string(ENOENT));
    if (!info.isFile()) // a pipe would never end
        return notReadable(path, noFile());
    if (info.size() > largest)
        return tooLarge(path, info.size(), largest);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return notReadable(path, file.errorString());
    QByteArray bytes = file.read(largest + 1); // it may have grown
    if (file.error() != QFileDevice::NoError)
        return notReadable(path, file.errorString());
    if (bytes.size() > largest)
        return tooLarge(path, bytes.size(), largest);
    return bytes;
}

Result<void> checkReplaceable(const QString &path)
{
    return FileReplacement(path).begin(); // never put in place
}

Result<void> replaceFile(const QString &path, const QByteArray &bytes, OldFile old)
{
    FileReplacement file(path);
    if (auto begun = file.begin(); !begun)
        return begun;
    file.write(bytes);
    if (auto isThere = file.bringToDisk(); !isThere)
        return isThere;
    if (old == OldFile::isKeptAsBackup && QFileInfo::exists(path)) {
        if (auto can = checkReplaceable(backupPath(path)); !can)
            return can;
        if (!keepBackup(path))
            return notWritten(backupPath(path), systemReason());
    }
    return file.replace();
}

} // namespace codewheel
