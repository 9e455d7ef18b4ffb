// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/file_access.h"

#include "encoder/sentence.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
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
    return refuse(RefusalKind::badInput, RefusalId::fileNotWritten, {path, reason});
}

QString noFile()
{
    return QCoreApplication::translate("codewheel::FileAccess", "It is no file.");
}

bool isOtherThanFile(const QString &path)
{
    const QFileInfo info(path);
    return info.exists() && !info.isFile();
}

std::int64_t megabytes(qint64 bytes)
{
    return (bytes + megabyte - 1) / megabyte;
}

tl::unexpected<Refusal> tooLarge(const QString &path, qint64 size, qint64 largest)
{
    return refuse(RefusalKind::badInput, RefusalId::fileTooLarge,
                  {path, megabytes(size), megabytes(largest)});
}

QString systemReason()
{
    return qt_error_string(errno);
}

bool writeAll(int file, QByteArrayView bytes)
{
    while (!bytes.isEmpty()) {
        const ssize_t written = ::write(file, bytes.data(), static_cast<std::size_t>(bytes.size()));
        if (written < 0 && errno != EINTR)
            return false;
        bytes = bytes.sliced(std::max<ssize_t>(written, 0));
    }
    return true;
}

// A second name for what stands at `from`; where the file system knows none, a copy.
bool linkOrCopy(const QString &from, const QString &to)
{
    return ::link(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) == 0 ||
           QFile::copy(from, to);
}

bool rename(const QString &from, const QString &to)
{
    return std::rename(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) == 0;
}

// The old file stays under its name, and has another one beside it.
bool keepBackup(const QString &path)
{
    const QString name = QStringLiteral("%1.%2~").arg(path).arg(::getpid());
    QFile::remove(name); // of a program that was killed here
    if (!linkOrCopy(path, name))
        return false;
    if (rename(name, backupPath(path)))
        return true;
    QFile::remove(name);
    return false;
}

// That the new name is on the disk too. Some file systems cannot tell.
void syncFolder(const QString &path)
{
    const int folder = ::open(QFile::encodeName(QFileInfo(path).absolutePath()).constData(),
                              O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0)
        return;
    ::fsync(folder);
    ::close(folder);
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
    if (isOtherThanFile(path))
        return notWritten(path, noFile());
    QSaveFile file(path); // never brought there
    if (!file.open(QIODevice::WriteOnly))
        return notWritten(path, file.errorString());
    return {};
}

Result<void> replaceFile(const QString &path, const QByteArray &bytes, OldFile old)
{
    if (isOtherThanFile(path))
        return notWritten(path, noFile());
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return notWritten(path, file.errorString());
    // QSaveFile would not tell that the disk is full, nor what goes wrong when the file is brought there.
    if (!writeAll(file.handle(), bytes) || ::fsync(file.handle()) != 0)
        return notWritten(path, systemReason());
    if (old == OldFile::isKeptAsBackup && QFileInfo::exists(path) && !keepBackup(path))
        return notWritten(backupPath(path), systemReason());
    if (!file.commit())
        return notWritten(path, file.errorString());
    syncFolder(path);
    return {};
}

} // namespace codewheel
